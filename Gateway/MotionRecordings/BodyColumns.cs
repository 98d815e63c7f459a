namespace Nowpose.Gateway.MotionRecordings;

/// <summary>The columns in the recording of a rigid body: time in s, position in m, unit quaternion.</summary>
static class BodyColumns
{
    public const string Header = "t_s,x,y,z,qx,qy,qz,qw";

    /// <summary>The columns of the quaternion.</summary>
    public const string Quaternion = "qx,qy,qz,qw";

    /// <summary>Minimum number of quaternion columns for which a header is probably a misspelt header of a rigid body.</summary>
    const int MinResembling = 3;

    static readonly string[] Names = Header.Split(',');

    static readonly string[] QuaternionNames = Quaternion.Split(',');

    /// <summary>Whether a header is exactly the header of a rigid body.</summary>
    public static bool Are(string[] header) => header.AsSpan().SequenceEqual(Names);

    /// <summary>Whether a header contains most columns of a quaternion, in any order and case.</summary>
    public static bool Resemble(string[] header) =>
        QuaternionNames.Count(name => header.Contains(name, StringComparer.OrdinalIgnoreCase)) >= MinResembling;
}
