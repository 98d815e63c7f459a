namespace UnityEngine;

/// <summary>A rotation in left-handed axes. A positive angle turns clockwise as seen from the tip of the axis towards its origin.</summary>
public struct Quaternion(float x, float y, float z, float w) : IEquatable<Quaternion>, IFormattable
{
    public const float kEpsilon = 1E-06f;

    public float x = x;
    public float y = y;
    public float z = z;
    public float w = w;

    public static Quaternion identity => new(0, 0, 0, 1);

    /// <summary>
    /// Euler angles in degrees, each from 0 to 360. The rotation about z is applied first, then the rotation about x, then the rotation about y.
    /// </summary>
    public Vector3 eulerAngles
    {
        readonly get => EulerAngles.Of(this);
        set => this = Euler(value);
    }

    public static float Dot(Quaternion a, Quaternion b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;

    public static Quaternion Normalize(Quaternion q)
    {
        var length = MathF.Sqrt(Dot(q, q));
        return length < Mathf.Epsilon ? identity : new Quaternion(q.x / length, q.y / length, q.z / length, q.w / length);
    }

    public static Quaternion Inverse(Quaternion rotation) => new(-rotation.x, -rotation.y, -rotation.z, rotation.w);

    public static Quaternion AngleAxis(float angle, Vector3 axis)
    {
        if (axis.sqrMagnitude == 0) return identity;

        var half = angle * Mathf.Deg2Rad / 2;
        var v = axis / axis.magnitude * MathF.Sin(half);
        return new Quaternion(v.x, v.y, v.z, MathF.Cos(half));
    }

    public static Quaternion Euler(float x, float y, float z) =>
        AngleAxis(y, Vector3.up) * AngleAxis(x, Vector3.right) * AngleAxis(z, Vector3.forward);

    public static Quaternion Euler(Vector3 euler) => Euler(euler.x, euler.y, euler.z);

    public static Quaternion LookRotation(Vector3 forward) => LookRotation(forward, Vector3.up);

    public static Quaternion LookRotation(Vector3 forward, Vector3 upwards)
    {
        if (forward.sqrMagnitude < Vector3.EqualitySquared) return identity;

        var z = forward / forward.magnitude;
        var x = Vector3.Cross(upwards, z);
        // If the forward direction is parallel to "up", the result is not unique. Returns the shortest rotation from forward.
        if (x.sqrMagnitude < Vector3.EqualitySquared) return FromToRotation(Vector3.forward, z);

        x /= x.magnitude;
        return RotationMatrix.ToQuaternion(x, Vector3.Cross(z, x), z);
    }

    public static Quaternion FromToRotation(Vector3 fromDirection, Vector3 toDirection)
    {
        var from = fromDirection.normalized;
        var to = toDirection.normalized;
        if (from == Vector3.zero || to == Vector3.zero) return identity;

        var cosine = Vector3.Dot(from, to);
        if (cosine > -1 + kEpsilon)
        {
            var axis = Vector3.Cross(from, to);
            return Normalize(new Quaternion(axis.x, axis.y, axis.z, 1 + cosine));
        }

        // The directions are opposite: returns half a turn about any perpendicular axis.
        var across = Vector3.Cross(from, MathF.Abs(from.x) < 0.9f ? Vector3.right : Vector3.up).normalized;
        return new Quaternion(across.x, across.y, across.z, 0);
    }

    public static float Angle(Quaternion a, Quaternion b)
    {
        var dot = MathF.Min(MathF.Abs(Dot(a, b)), 1);
        return dot > 1 - kEpsilon ? 0 : MathF.Acos(dot) * 2 * Mathf.Rad2Deg;
    }

    public static Quaternion operator *(Quaternion lhs, Quaternion rhs) => new(
        lhs.w * rhs.x + lhs.x * rhs.w + lhs.y * rhs.z - lhs.z * rhs.y,
        lhs.w * rhs.y + lhs.y * rhs.w + lhs.z * rhs.x - lhs.x * rhs.z,
        lhs.w * rhs.z + lhs.z * rhs.w + lhs.x * rhs.y - lhs.y * rhs.x,
        lhs.w * rhs.w - lhs.x * rhs.x - lhs.y * rhs.y - lhs.z * rhs.z);

    public static Vector3 operator *(Quaternion rotation, Vector3 point)
    {
        var v = new Vector3(rotation.x, rotation.y, rotation.z);
        var t = Vector3.Cross(v, point) * 2;
        return point + t * rotation.w + Vector3.Cross(v, t);
    }

    public static bool operator ==(Quaternion lhs, Quaternion rhs) => Dot(lhs, rhs) > 1 - kEpsilon;
    public static bool operator !=(Quaternion lhs, Quaternion rhs) => !(lhs == rhs);

    public readonly bool Equals(Quaternion other) => x.Equals(other.x) && y.Equals(other.y) && z.Equals(other.z) && w.Equals(other.w);
    public override readonly bool Equals(object other) => other is Quaternion q && Equals(q);
    public override readonly int GetHashCode() => HashCode.Combine(x, y, z, w);

    public override readonly string ToString() => ToString(null, null);
    public readonly string ToString(string format) => ToString(format, null);

    public readonly string ToString(string format, IFormatProvider formatProvider) =>
        new Vector4(x, y, z, w).ToString(string.IsNullOrEmpty(format) ? "F5" : format, formatProvider);
}
