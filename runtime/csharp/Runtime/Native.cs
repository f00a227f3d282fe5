// The functions of nearfield.h that the binding calls.
using System;
using System.Runtime.InteropServices;

namespace Nearfield
{
    /// <summary>A NearfieldField and, behind it, the bytes that it borrows. Calls keep it alive; it is freed once.</summary>
    internal sealed class FieldHandle : SafeHandle
    {
        private const int FieldSize = 256;

        internal FieldHandle(byte[] bytes) : base(IntPtr.Zero, true)
        {
            SetHandle(Marshal.AllocHGlobal(checked(FieldSize + bytes.Length)));
            Marshal.Copy(bytes, 0, Bytes, bytes.Length);
        }

        internal IntPtr Bytes => IntPtr.Add(handle, FieldSize);

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            Marshal.FreeHGlobal(handle);
            return true;
        }
    }

    internal static class Native
    {
#if (UNITY_IOS || UNITY_WEBGL) && !UNITY_EDITOR
        private const string Library = "__Internal";
#else
        private const string Library = "nearfield_c";
#endif
        internal const uint AbiVersion = 1;

        [DllImport(Library)] internal static extern uint nearfield_abi_version();
        [DllImport(Library)] internal static extern IntPtr nearfield_result_text(int result);
        [DllImport(Library)] internal static extern int nearfield_open(FieldHandle field, IntPtr bytes, UIntPtr length);
        [DllImport(Library)] internal static extern int nearfield_validate(FieldHandle field);
        [DllImport(Library)] internal static extern Info nearfield_info(FieldHandle field);
        [DllImport(Library)] internal static extern float nearfield_distance(FieldHandle field, Vector point);
        [DllImport(Library)] internal static extern Sample nearfield_distance_and_gradient(FieldHandle field, Vector point);
        [DllImport(Library)] internal static extern Vector nearfield_normal(FieldHandle field, Vector point);
        [DllImport(Library)] internal static extern float nearfield_clearance(FieldHandle field, Vector point);
        [DllImport(Library)] internal static extern FieldRange nearfield_range(FieldHandle field, Vector min, Vector max);
        [DllImport(Library)] internal static extern FieldRayHit nearfield_raycast(FieldHandle field, FieldRay ray);
        [DllImport(Library)] internal static extern ClosestPoint nearfield_closest_point(FieldHandle field, Vector point);

        [DllImport(Library)] [return: MarshalAs(UnmanagedType.I1)]
        internal static extern bool nearfield_is_clear(FieldHandle field, Vector centre, float radius);

        [DllImport(Library)]
        internal static extern UIntPtr nearfield_distances(
            FieldHandle field, [In] Vector[] points, UIntPtr pointStride,
            [In, Out] float[] distances, UIntPtr distanceStride, UIntPtr count);

        [DllImport(Library)]
        internal static extern UIntPtr nearfield_distances_and_gradients(
            FieldHandle field, [In] Vector[] points, UIntPtr pointStride,
            [In, Out] float[] distances, UIntPtr distanceStride,
            [In, Out] Vector[] gradients, UIntPtr gradientStride, UIntPtr count);
    }
}
