using Nowpose.Cli.Studies;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Motion;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>A quarter turn of the youBot's first axis with the arm extended, and back: a motion like that of the paper's Fig. 16.</summary>
/// <remarks>
/// The paper states neither the stroke nor the limits of the motion. Here, the maximum speed is 90 % of the URDF's limit and is reached
/// within 0.3 s, as in the profile of Figs 12 to 14. A move then takes 1.4 s, the duration shown in the paper's Fig. 18.
/// Times are in seconds since the start of the swing unless stated otherwise.
/// </remarks>
sealed class YoubotSwing
{
    /// <summary>Rest between moves, s.</summary>
    const double Dwell = 0.5;

    const double Stroke = Math.PI / 2;
    const double Ahead = 2.9671;

    /// <summary>Speed divided by acceleration, and acceleration divided by jerk, s.</summary>
    const double RampTime = 0.2, JerkTime = 0.1;

    /// <summary>Time span from the oldest sample of a prediction to the display time, s: (n + 1)·T_s + L for the quadratic.</summary>
    const double Span = 0.250;

    // Strokes of the shorter moves before the swing, rad, like those of a working robot. They end where the swing begins.
    static readonly double[] Rehearsal = [0.6, -1.0, 0.9, -0.5];

    // Joint positions in rad or m: the arm is extended; the gripper points forward and down and is open.
    static readonly (string Name, double Position)[] Pose =
    [
        ("arm_joint_2", 2.0345), ("arm_joint_3", -1.9482), ("arm_joint_4", 2.389), ("arm_joint_5", 2.9234), ("gripper_finger_joint_l", 0.0115),
    ];

    readonly List<(double Start, double From, SevenPhaseProfile Profile)> _moves = [];
    readonly ForwardKinematics _kinematics;
    readonly int _axis;
    readonly double[] _pose;
    readonly double _headingAhead;
    readonly int _turnSign;

    /// <param name="isCold">Whether the swing is the first motion. If not, a few shorter moves precede it.</param>
    /// <param name="firstRest">Rest before the first move, s.</param>
    public YoubotSwing(bool isCold, double firstRest = 1)
    {
        Robot = RobotFiles.Load("youbot");
        _kinematics = new ForwardKinematics(Robot);
        _axis = Robot.IndexOfMovingJoint("arm_joint_1");
        _pose = new double[Robot.MovingJoints.Count];
        foreach (var (name, position) in Pose) _pose[Robot.IndexOfMovingJoint(name)] = position;
        Robot.CompleteMimics(_pose, new bool[_pose.Length]);
        RigidTransform ahead = ToolAt(Ahead), next = ToolAt(Ahead + 0.1);
        Radius = RadiusOf(ahead);
        _headingAhead = HeadingOf(ahead.X, ahead.Y);
        _turnSign = Math.Sign(Math.IEEERemainder(HeadingOf(next.X, next.Y) - _headingAhead, 2 * Math.PI));

        var (time, angle) = (firstRest, FirstAngle);
        foreach (var stroke in isCold ? [] : Rehearsal) Add(stroke, ref time, ref angle);
        Start = time;
        Add(Stroke, ref time, ref angle);
        MoveSeconds = time - Start - Dwell;
        Add(-Stroke, ref time, ref angle);
        Motion = new AxisMotion("youBot's swing", time, AngleAt);
    }

    public RobotModel Robot { get; }

    /// <summary>Radius of the tool centre point's circular path, m.</summary>
    public double Radius { get; }

    /// <summary>Position of the first axis, rad, over the time since the start of the motion, s.</summary>
    public AxisMotion Motion { get; }

    /// <summary>Start of the swing, s since the start of the motion.</summary>
    public double Start { get; }

    /// <summary>Duration of the move in one direction, s.</summary>
    public double MoveSeconds { get; }

    /// <summary>Position of the first axis at the start of the swing, rad.</summary>
    public static double FirstAngle => Ahead - Stroke / 2;

    /// <summary>Maximum speed of the tool centre point, mm/s.</summary>
    public double FullSpeed => ToolSpeedAt(MoveSeconds / 2);

    /// <summary>Returns whether the robot is moving at t and its velocity has been constant for the time span of a prediction.</summary>
    public bool IsSteadyAt(double t) => IsStraightAt(t) && IsStraightAt(t - Span);

    /// <summary>Gets whether the robot moves, and its velocity has changed within the time span of a prediction.</summary>
    public bool IsCurvedAt(double t) => VelocityAt(t) != 0 && !IsSteadyAt(t);

    /// <summary>Gets the speed of the tool centre point, mm/s; never negative.</summary>
    public double ToolSpeedAt(double t) => 1000 * Radius * Math.Abs(VelocityAt(t));

    /// <summary>Gets the poses of all links for a position of the first axis, rad.</summary>
    public RigidTransform[] LinksAt(double angle)
    {
        var positions = (double[])_pose.Clone();
        positions[_axis] = angle;
        var links = new RigidTransform[Robot.Links.Count];
        _kinematics.Compute(positions, links);
        return links;
    }

    /// <summary>Gets the positions of all moving joints, rad or m. Does not allocate.</summary>
    /// <param name="sinceMotion">Time since the start of the motion, s.</param>
    public void PositionsAt(double sinceMotion, Span<double> positions)
    {
        _pose.CopyTo(positions);
        positions[_axis] = AngleAt(sinceMotion);
    }

    /// <summary>Gets the position of the first axis, rad, from the position of the tool in the base frame, m.</summary>
    public double AngleOf(double x, double y)
    {
        var turn = Math.IEEERemainder(HeadingOf(x, y) - _headingAhead, 2 * Math.PI);
        return Ahead + _turnSign * turn;
    }

    /// <summary>Gets the distance between the tool centre points at two positions of the first axis, mm.</summary>
    public double GapMm(double angle, double other) => 2000 * Radius * Math.Abs(Math.Sin((angle - other) / 2));

    /// <summary>Gets the distance along the circular path from the start of the swing, mm.</summary>
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

    (double Start, double From, SevenPhaseProfile Profile) MoveAt(double sinceMotion)
    {
        var move = _moves.Count - 1;
        while (move > 0 && _moves[move].Start > sinceMotion) move--;
        return _moves[move];
    }

    RigidTransform ToolAt(double angle) => LinksAt(angle)[Robot.IndexOfLink(Robot.ToolLink.Name)];

    // The first joint's axis does not pass through the origin of the base frame.
    double RadiusOf(in RigidTransform tool) => Math.Sqrt(Math.Pow(tool.X - AxisOrigin.X, 2) + Math.Pow(tool.Y - AxisOrigin.Y, 2));

    double HeadingOf(double x, double y) => Math.Atan2(y - AxisOrigin.Y, x - AxisOrigin.X);

    RigidTransform AxisOrigin => Robot.MovingJoints[_axis].Origin;
}
