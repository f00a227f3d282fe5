using System;
using System.Runtime.InteropServices;

namespace Nearfield
{
    /// <summary>
    /// A field that is open for queries. Units and frame are those of the mesh; distances are negative inside.
    /// </summary>
    /// <remarks>
    /// Any number of threads may query one field. Outside its box the distance is an upper bound: that at the nearest point of the
    /// box plus the distance to it. A coordinate that is NaN gives NaN. After Dispose every query throws ObjectDisposedException.
    /// </remarks>
    public sealed class Field : IDisposable
    {
        private const int VectorSize = 12;
        private const int FloatSize = 4;

        private readonly FieldHandle handle;

        /// <summary>Opens a copy of the bytes of a .nfd and checks every one of them.</summary>
        /// <exception cref="FieldException">They are no valid field.</exception>
        public Field(byte[] bytes)
        {
            if (bytes == null) throw new ArgumentNullException(nameof(bytes));
            uint version = Native.nearfield_abi_version();
            if (version != Native.AbiVersion)
                throw new NotSupportedException($"the library has version {version} of its interface, not {Native.AbiVersion}");

            handle = new FieldHandle(bytes);
            int result = Native.nearfield_open(handle, handle.Bytes, (UIntPtr)bytes.Length);
            if (result == 0) result = Native.nearfield_validate(handle);
            if (result != 0)
            {
                handle.Dispose();
                throw new FieldException(result, Marshal.PtrToStringAnsi(Native.nearfield_result_text(result)));
            }
        }

        public void Dispose() => handle.Dispose();

        public Info Info => Native.nearfield_info(handle);

        /// <summary>Signed distance from a point to the surface.</summary>
        public float Distance(Vector point) => Native.nearfield_distance(handle, point);

        /// <summary>Signed distance, to the bit, and gradient.</summary>
        public Sample DistanceAndGradient(Vector point) => Native.nearfield_distance_and_gradient(handle, point);

        /// <summary>Unit vector along the gradient, or zero where there is none.</summary>
        public Vector Normal(Vector point) => Native.nearfield_normal(handle, point);

        /// <summary>The distance less the largest error that was measured when the field was baked. Nothing is proved.</summary>
        public float Clearance(Vector point) => Native.nearfield_clearance(handle, point);

        /// <summary>Whether the clearance at a point exceeds a radius.</summary>
        public bool IsClear(Vector centre, float radius) => Native.nearfield_is_clear(handle, centre, radius);

        /// <summary>Bounds of a continuous field over a box; infinite unless the corners are finite and in order.</summary>
        public FieldRange Range(Vector min, Vector max) => Native.nearfield_range(handle, min, max);

        /// <summary>Follows a ray to the surface, inside the box of the field, with at most 512 queries.</summary>
        public FieldRayHit Raycast(FieldRay ray) => Native.nearfield_raycast(handle, ray);

        /// <summary>Goes down the gradient to the surface. That the end is the closest point is not promised.</summary>
        public ClosestPoint ClosestPoint(Vector point) => Native.nearfield_closest_point(handle, point);

        /// <summary>Distances at all points, in one call without copies.</summary>
        /// <exception cref="ArgumentException">The arrays are not of one length.</exception>
        public void Distances(Vector[] points, float[] distances)
        {
            Expect(points, distances, nameof(distances));
            Native.nearfield_distances(
                handle, points, (UIntPtr)VectorSize, distances, (UIntPtr)FloatSize, (UIntPtr)points.Length);
        }

        /// <summary>Distances and gradients at all points, in one call without copies.</summary>
        /// <exception cref="ArgumentException">The arrays are not of one length.</exception>
        public void DistancesAndGradients(Vector[] points, float[] distances, Vector[] gradients)
        {
            Expect(points, distances, nameof(distances));
            Expect(points, gradients, nameof(gradients));
            Native.nearfield_distances_and_gradients(
                handle, points, (UIntPtr)VectorSize, distances, (UIntPtr)FloatSize,
                gradients, (UIntPtr)VectorSize, (UIntPtr)points.Length);
        }

        private static void Expect(Vector[] points, Array answers, string name)
        {
            if (points == null) throw new ArgumentNullException(nameof(points));
            if (answers == null) throw new ArgumentNullException(name);
            if (answers.Length != points.Length) throw new ArgumentException($"{points.Length} points", name);
        }
    }
}
