// What the answers are made of. Layouts are those of nearfield.h.
using System;
using System.Runtime.InteropServices;

namespace Nearfield
{
    /// <summary>A point, direction or gradient: mesh units, mesh frame.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Vector
    {
        public float X, Y, Z;

        public Vector(float x, float y, float z) { X = x; Y = y; Z = z; }

#if UNITY_5_3_OR_NEWER
        // Numbers as they are: Unity's frame is left-handed, so bake meshes as Unity imports them.
        public static implicit operator UnityEngine.Vector3(Vector v) => new UnityEngine.Vector3(v.X, v.Y, v.Z);
        public static implicit operator Vector(UnityEngine.Vector3 v) => new Vector(v.x, v.y, v.z);
#endif

        public override string ToString() => $"({X}, {Y}, {Z})";
    }

    /// <summary>A distance and its gradient, whose length is near 1, but not normalized.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Sample
    {
        public float Distance;
        public Vector Gradient;
    }

    /// <summary>Bounds of a field over a box, mesh units.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct FieldRange
    {
        public float Min, Max;
    }

    /// <summary>Errors measured over a set of points: mesh units, finite, at least 0.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Errors
    {
        public float Rmse, P99, Max;
    }

    /// <summary>What a field is and how wrong it was found to be when it was baked; nearfield.h says what each is.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Info
    {
        public Vector BoxMin, BoxMax;
        public float Diagonal, TargetError, Lipschitz, MaxError;
        public Errors Uniform, Band;
        public float SeamMax;
        public uint SampleCount, DoubtfulSigns;
        public ushort FormatMinor, BakerMajor, BakerMinor, BakerPatch;
        // 16 and 8 bytes: no array, so that the struct crosses by value.
        private uint meshHash0, meshHash1, meshHash2, meshHash3, settingsHash0, settingsHash1;

        /// <summary>Hash of the mesh that was baked, hexadecimal.</summary>
        public string MeshHash => Hex(meshHash0, meshHash1, meshHash2, meshHash3);

        /// <summary>Hash of the settings that it was baked with, hexadecimal.</summary>
        public string SettingsHash => Hex(settingsHash0, settingsHash1);

        private static string Hex(params uint[] words)
        {
            var bytes = new byte[4 * words.Length];
            Buffer.BlockCopy(words, 0, bytes, 0, bytes.Length);
            return BitConverter.ToString(bytes).Replace("-", "").ToLowerInvariant();
        }
    }

    /// <summary>What became of a ray.</summary>
    public enum RayEnd
    {
        /// <summary>It left the box or ended first; or it is not finite or has no direction.</summary>
        Miss = 0,
        Hit = 1,
        /// <summary>It grazed the surface for longer than its 512 steps: clear up to the distance.</summary>
        OutOfSteps = 2,
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct FieldRay
    {
        public Vector Origin;
        /// <summary>Of any length but 0.</summary>
        public Vector Direction;
        /// <summary>Mesh units; may be infinite.</summary>
        public float Length;
        /// <summary>The ray ends where the field is at most so much, mesh units.</summary>
        public float Within;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct FieldRayHit
    {
        public RayEnd End;
        public uint Steps;
        /// <summary>Along the ray, mesh units.</summary>
        public float Distance;
        /// <summary>Of a hit alone, as is the unit normal.</summary>
        public Vector Point, Normal;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct ClosestPoint
    {
        public Vector Point;
        /// <summary>The field there, mesh units: how far the descent stayed from the surface.</summary>
        public float Residual;
        public uint Steps;
    }

    /// <summary>Bytes that are no field, or that this reader does not read.</summary>
    public sealed class FieldException : Exception
    {
        /// <summary>NearfieldResult of nearfield.h.</summary>
        public int Result { get; }

        internal FieldException(int result, string message) : base(message) { Result = result; }
    }
}
