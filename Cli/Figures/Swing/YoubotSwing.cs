using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Studies;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>The youBot turns its first axis by a quarter, arm out, and back: a motion such as the paper's Fig. 16 shows.</summary>
/// <remarks>
/// The paper gives neither stroke nor limits. These are a quarter turn at 90 % of the URDF's speed, which is reached as quickly as
/// in the profile of Figs 12 to 14, within 0.3 s; the whole move then takes the 1.4 s that the paper's Fig. 18 looks at.
/// Times are seconds since the swing's start unless said otherwise.
/// </remarks>
sealed class YoubotSwing
{
    /// <summary>Rest between moves, and before the first, s: by then samples have arrived.</summary>
    const double Dwell = 0.5, FirstRest = 1;

    const double Stroke = Math.PI / 2;
    const double Ahead = 2.9671;

    /// <summary>Speed over acceleration and acceleration over jerk, s.</summary>
    const double RampTime = 0.2, JerkTime = 0.1;

    /// <summary>What a prediction spans, s: from its oldest sample to the frame, (n + 1)·T_s + L for the quadratic.</summary>
    const double Span = 0.250;

    // rad: shorter moves, as a robot at work makes them; they end where the swing begins.
    static readonly double[] Rehearsal = [0.6, -1.0, 0.9, -0.5];

    // rad: the arm reaches out, gripper forward and down, open.
    static readonly (string Name, double Position)[] Pose =
    [
        ("arm_joint_2", 2.0345), ("arm_joint_3", -1.9482), ("arm_joint_4", 2.389), ("arm_joint_5", 2.9234), ("gripper_finger_joint_l", 0.0115),
    ];

    readonly List<(double Start, double From, SevenPhaseProfile Profile)> _moves = [];
    readonly ForwardKinematics _kinematics;
    readonly int _axis;
    readonly double[] _pose;

    /// <param name="isCold">The swing is the first that is seen of the robot; else a few shorter moves go before.</param>
    public YoubotSwing(bool isCold)
    {
        Robot = RobotFiles.Load("youbot");
        _kinematics = new ForwardKinematics(Robot);
        _axis = Robot.IndexOfMovingJoint("arm_joint_1");
        _pose = new double[Robot.MovingJoints.Count];
        foreach (var (name, position) in Pose) _pose[Robot.IndexOfMovingJoint(name)] = position;
        Robot.CompleteMimics(_pose, new bool[_pose.Length]);
        Radius = RadiusOf(ToolAt(Ahead));

        var (time, angle) = (FirstRest, FirstAngle);
        foreach (var stroke in isCold ? [] : Rehearsal) Add(stroke, ref time, ref angle);
        Start = time;
        Add(Stroke, ref time, ref angle);
        MoveSeconds = time - Start - Dwell;
        Add(-Stroke, ref time, ref angle);
        Motion = new AxisMotion("youBot's swing", time, AngleAt);
    }

    public RobotModel Robot { get; }

    /// <summary>Of the circle that the tool centre point goes along, m.</summary>
    public double Radius { get; }

    /// <summary>The first axis in rad, over seconds since the motion's start.</summary>
    public AxisMotion Motion { get; }

    /// <summary>When the swing starts, s since the motion's start.</summary>
    public double Start { get; }

    /// <summary>Length of the move one way, s.</summary>
    public double MoveSeconds { get; }

    /// <summary>Where the swing begins, rad.</summary>
    public static double FirstAngle => Ahead - Stroke / 2;

    /// <summary>Speed of the tool centre point at its fastest, mm/s.</summary>
    public double FullSpeed => ToolSpeedAt(MoveSeconds / 2);

    /// <summary>Whether the robot moves at constant velocity, and has for as long as a prediction spans.</summary>
    public bool IsSteadyAt(double t) => IsStraightAt(t) && IsStraightAt(t - Span);

    /// <summary>Whether the robot moves, and its velocity has changed within what a prediction spans.</summary>
    public bool IsCurvedAt(double t) => VelocityAt(t) != 0 && !IsSteadyAt(t);

    /// <summary>Speed of the tool centre point, mm/s, 0 or more.</summary>
    public double ToolSpeedAt(double t) => 1000 * Radius * Math.Abs(VelocityAt(t));

    /// <summary>All link poses with the first axis at an angle, rad.</summary>
    public RigidTransform[] LinksAt(double angle)
    {
        var positions = (double[])_pose.Clone();
        positions[_axis] = angle;
        var links = new RigidTransform[Robot.Links.Count];
        _kinematics.Compute(positions, links);
        return links;
    }

    /// <summary>Distance of the tool centre points at two angles, mm.</summary>
    public double GapMm(double angle, double other) => 2000 * Radius * Math.Abs(Math.Sin((angle - other) / 2));

    /// <summary>Way along the circle since the swing's beginning, mm.</summary>
    public double WayMm(double angle) => 1000 * Radius * (angle - FirstAngle);

    void Add(double stroke, ref double time, ref double angle)
    {
        var speed = 0.9 * Robot.MovingJoints[_axis].Limits.Velocity;
        var profile = new SevenPhaseProfile(stroke, speed, speed / RampTime, speed / RampTime / JerkTime);
        _moves.Add((time, angle, profile));
        time += profile.Duration + Dwell;
        angle += stroke;
    }

    double AngleAt(double sinceMotion)
    {
        var (start, from, profile) = MoveAt(sinceMotion);
        return from + profile.PositionAt(sinceMotion - start);
    }

    double VelocityAt(double t)
    {
        var (start, _, profile) = MoveAt(Start + t);
        return profile.VelocityAt(Start + t - start);
    }

    bool IsStraightAt(double t)
    {
        var (start, _, profile) = MoveAt(Start + t);
        return VelocityAt(t) != 0 && Math.Abs(profile.AccelerationAt(Start + t - start)) < 1e-9;
    }

    (double Start, double From, SevenPhaseProfile Profile) MoveAt(double sinceMotion) =>
        _moves[Math.Max(0, _moves.FindLastIndex(move => move.Start <= sinceMotion))];

    RigidTransform ToolAt(double angle) => LinksAt(angle)[Robot.IndexOfLink(Robot.ToolLink.Name)];

    // About the first joint's own axis, which is not the base frame's.
    double RadiusOf(in RigidTransform tool)
    {
        var axis = Robot.MovingJoints[_axis].Origin;
        return Math.Sqrt(Math.Pow(tool.X - axis.X, 2) + Math.Pow(tool.Y - axis.Y, 2));
    }
}
