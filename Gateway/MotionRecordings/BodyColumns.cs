namespace Nowpose.Gateway.MotionRecordings;

/// <summary>The columns of the recording of a rigid body: time in s, position in m, unit quaternion.</summary>
static class BodyColumns
{
    public const string Header = "t_s,x,y,z,qx,qy,qz,qw";

    /// <summary>The columns of the quaternion.</summary>
    public const string Quaternion = "qx,qy,qz,qw";

    /// <summary>Number of quaternion columns in a header that is not meant for joints.</summary>
    const int MinResembling = 3;

    static readonly string[] Names = Header.Split(',');

    static readonly string[] QuaternionNames = Quaternion.Split(',');

    /// <summary>Whether a header is that of a rigid body.</summary>
    public static bool Are(string[] header) => header.AsSpan().SequenceEqual(Names);

    /// <summary>Whether a header contains most columns of a quaternion, in any order and case.</summary>
    public static bool Resemble(string[] header) =>
        QuaternionNames.Count(name => header.Contains(name, StringComparer.OrdinalIgnoreCase)) >= MinResembling;
}
