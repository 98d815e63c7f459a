using Nowpose.Kinematics;

namespace Nowpose.Benchmarks;

/// <summary>An arm with seven revolute joints and right angles between their axes, and a continuous motion of all joints.</summary>
static class SevenJointArm
{
    public const double PeriodSeconds = 6.4;

    // Transforms from parent to child in metres and radians, base first.
    static readonly string[] Origins =
    [
        "xyz='0 0 0.33'", "rpy='-1.5707963 0 0'", "xyz='0 -0.31 0' rpy='1.5707963 0 0'", "xyz='0.08 0 0' rpy='1.5707963 0 0'",
        "xyz='-0.08 0.38 0' rpy='-1.5707963 0 0'", "rpy='1.5707963 0 0'", "xyz='0.09 0 0' rpy='1.5707963 0 0'",
    ];

    public static readonly RobotModel Model = UrdfReader.Read(
        $"""
        <robot name='seven_joints'>
          <link name='link_0'/>{string.Concat(Origins.Select(Joint))}<link name='tool_centre_point'/>
          <joint name='tool' type='fixed'><parent link='link_7'/><child link='tool_centre_point'/>
            <origin xyz='0 0 0.21' rpy='0 0 -0.7853982'/></joint>
        </robot>
        """,
        "seven-joint arm");

    public static readonly string[] JointNames = [.. Model.MovingJoints.Select(joint => joint.Name)];

    /// <summary>Returns the joint positions at a given time, rad.</summary>
    public static double[] PositionsAt(double seconds) =>
        [.. Enumerable.Range(1, Origins.Length).Select(joint => 1.5 * Math.Sin(2 * Math.PI * seconds / PeriodSeconds + joint))];

    static string Joint(string origin, int index) =>
        $"""
        <link name='link_{index + 1}'/>
        <joint name='joint_{index + 1}' type='revolute'><parent link='link_{index}'/><child link='link_{index + 1}'/>
          <origin {origin}/><axis xyz='0 0 1'/><limit lower='-2.9' upper='2.9' velocity='2' effort='80'/></joint>
        """;
}
