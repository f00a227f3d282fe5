// As much of Unity as the binding names, to see that those lines compile. It shows nothing about Unity itself.
namespace UnityEngine
{
    public struct Vector3
    {
        public float x, y, z;

        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
    }
}
