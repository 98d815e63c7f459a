using Nowpose.Gateway.Robots;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Studies;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>The youBot turns its first axis by a quarter, arm out, and back: a motion such as the paper's Fig. 16 shows.</summary>
/// <remarks>
/// The paper gives neither stroke nor limits. These are a quarter turn at 90 % of the URDF's speed, which is reached as quickly as
/// in the profile of Figs 12 to 14, within 0.3 s; the whole move then takes the 1.4 s that the paper's Fig. 18 looks at.
/// </remarks>
sealed class YoubotSwing
{
    /// <summary>The robot rests this long before it moves, s.</summary>
    public const double Start = 0.6;

    const double Dwell = 0.5;
    const double Stroke = Math.PI / 2;
    const double Ahead = 2.9671;

    /// <summary>Speed over acceleration and acceleration over jerk, s.</summary>
    const double RampTime = 0.2, JerkTime = 0.1;

    /// <summary>What a prediction spans, s: from its oldest sample to the frame, (n + 1)·T_s + L for the quadratic.</summary>
    const double Span = 0.250;

    // rad: the arm reaches out, gripper forward and down, open.
    static readonly (string Name, double Position)[] Pose =
    [
        ("arm_joint_2", 2.0345), ("arm_joint_3", -1.9482), ("arm_joint_4", 2.389), ("arm_joint_5", 2.9234), ("gripper_finger_joint_l", 0.0115),
    ];

    readonly SevenPhaseProfile _move;
    readonly int _axis;
    readonly double[] _pose;

    public YoubotSwing()
    {
        Robot = RobotFiles.Load("youbot");
        Kinematics = new ForwardKinematics(Robot);
        _axis = Robot.IndexOfMovingJoint("arm_joint_1");
        var speed = 0.9 * Robot.MovingJoints[_axis].Limits.Velocity;
        _move = new SevenPhaseProfile(Stroke, speed, speed / RampTime, speed / RampTime / JerkTime);
        _pose = new double[Robot.MovingJoints.Count];
        foreach (var (name, position) in Pose) _pose[Robot.IndexOfMovingJoint(name)] = position;
        Robot.CompleteMimics(_pose, new bool[_pose.Length]);
        Radius = RadiusOf(ToolAt(Ahead));
        Motion = new AxisMotion("youBot's swing", Start + 2 * (_move.Duration + Dwell), AngleAt);
    }

    public RobotModel Robot { get; }

    public ForwardKinematics Kinematics { get; }

    /// <summary>Of the circle that the tool centre point goes along, m.</summary>
    public double Radius { get; }

    /// <summary>The first axis in rad.</summary>
    public AxisMotion Motion { get; }

    /// <summary>Where the swing begins, rad.</summary>
    public static double FirstAngle => Ahead - Stroke / 2;

    /// <summary>Length of the move one way, s.</summary>
    public double MoveSeconds => _move.Duration;

    /// <summary>Whether the robot moves at constant velocity, and has for as long as a prediction spans.</summary>
    public bool IsSteadyAt(double t) => IsStraightAt(t) && IsStraightAt(t - Span);

    /// <summary>Whether the robot moves, and its velocity has changed within what a prediction spans.</summary>
    public bool IsCurvedAt(double t) => _move.VelocityAt(InMove(t)) != 0 && !IsSteadyAt(t);

    /// <summary>Speed of the tool centre point, mm/s, 0 or more.</summary>
    public double ToolSpeedAt(double t) => 1000 * Radius * _move.VelocityAt(InMove(t));

    /// <summary>All link poses with the first axis at an angle, rad.</summary>
    public RigidTransform[] LinksAt(double angle)
    {
        var positions = (double[])_pose.Clone();
        positions[_axis] = angle;
        var links = new RigidTransform[Robot.Links.Count];
        Kinematics.Compute(positions, links);
        return links;
    }

    /// <summary>Distance of the tool centre points at two angles, mm.</summary>
    public double GapMm(double angle, double other) => 2000 * Radius * Math.Abs(Math.Sin((angle - other) / 2));

    /// <summary>Way along the circle since the swing's beginning, mm.</summary>
    public double WayMm(double angle) => 1000 * Radius * (angle - FirstAngle);

    bool IsStraightAt(double t) => _move.VelocityAt(InMove(t)) != 0 && Math.Abs(_move.AccelerationAt(InMove(t))) < 1e-9;

    double AngleAt(double t) => t <= Start + _move.Duration + Dwell
        ? FirstAngle + _move.PositionAt(t - Start)
        : FirstAngle + Stroke - _move.PositionAt(InMove(t));

    double InMove(double t) => t <= Start + _move.Duration + Dwell ? t - Start : t - Start - _move.Duration - Dwell;

    RigidTransform ToolAt(double angle) => LinksAt(angle)[Robot.IndexOfLink(Robot.ToolLink.Name)];

    // About the first joint's own axis, which is not the base frame's.
    double RadiusOf(in RigidTransform tool)
    {
        var axis = Robot.MovingJoints[_axis].Origin;
        return Math.Sqrt(Math.Pow(tool.X - axis.X, 2) + Math.Pow(tool.Y - axis.Y, 2));
    }
}
