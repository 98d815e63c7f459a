namespace UnityEngine;

public struct Pose(Vector3 position, Quaternion rotation) : IEquatable<Pose>
{
    public Vector3 position = position;
    public Quaternion rotation = rotation;

    public static bool operator ==(Pose a, Pose b) => a.position == b.position && a.rotation == b.rotation;
    public static bool operator !=(Pose a, Pose b) => !(a == b);

    public readonly bool Equals(Pose other) => position.Equals(other.position) && rotation.Equals(other.rotation);
    public override readonly bool Equals(object obj) => obj is Pose p && Equals(p);
    public override readonly int GetHashCode() => HashCode.Combine(position, rotation);

    public override readonly string ToString() => ToString(null);
    public readonly string ToString(string format) => $"({position.ToString(format)}, {rotation.ToString(format)})";
}
