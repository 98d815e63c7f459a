using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Cli.SessionFiles;

/// <summary>Reads the fields of lines of version 1, as specified in <c>session-file.md</c>.</summary>
static class SessionLines
{
    /// <summary>The maximum values that a sync reply can state.</summary>
    const long MaxResolutionNs = uint.MaxValue, MaxServerBoundNs = uint.MaxValue * 1000L;

    public static SessionHeader ReadHeader(LineFields line)
    {
        var robot = line.Object("robot");
        var own = ReadJoints(robot);
        var others = line.Has("robots") ? line.Objects("robots").SelectMany(ReadFurtherJoints) : [];
        return new SessionHeader(robot.Text("name"), own.Count, [.. own, .. others], ReadPrediction(line, line.Object("settings")));
    }

    // Samples have the same names. The namespace can be empty if the robot of the header has one; /joint_1 is then the joint of the further robot.
    static List<SessionHeader.Joint> ReadFurtherJoints(LineFields robot)
    {
        var name = robot.Text("namespace");
        return ReadJoints(robot).ConvertAll(joint => joint with { Name = name + "/" + joint.Name });
    }

    static List<SessionHeader.Joint> ReadJoints(LineFields robot)
    {
        var joints = new List<SessionHeader.Joint>();
        foreach (var joint in robot.Objects("joints").Select(ReadJoint))
        {
            if (joints.Any(other => other.Name == joint.Name)) throw robot.Wrong("joints", SessionFileMessages.JointTwice(joint.Name));
            joints.Add(joint);
        }

        return joints;
    }

    /// <returns>The line; null if its kind is unknown or not used.</returns>
    public static SessionLine Read(LineFields line) => line.Text("kind") switch
    {
        "session" => throw new InputException(SessionFileMessages.SecondHeader(line.Place)),
        "sync" => ReadSync(line),
        "robot" => new RobotLine(ReadFurtherJoints(line)),
        "sample" => ReadSample(line),
        "plan" => ReadPlan(line),
        "pose" => ReadPose(line),
        "signal" => new SignalLine(
            ControlTime.FromNanoseconds(line.Whole("stamp_ns")), Name(line, "name"), line.Number("value"), line.TextOrNull("dropped")),
        "frame" => new FrameLine(
            HeadsetTime.FromNanoseconds(line.Whole("start_ns")),
            LightIn(line), line.Numbers("joints")),
        "object" => ReadObject(line),
        "clock" => new ClockChangeLine(line.FlagOr("new_start", false)),
        "lost" => new LostLine(line.Whole("count")),
        "end" => new EndLine(),
        _ => null,
    };

    static PredictionSettings ReadPrediction(LineFields line, LineFields settings)
    {
        try
        {
            return new PredictionSettings(
                settings.Text("predictor"), settings.Number("horizon_cap_ms"), settings.Number("maximum_gap_ms"),
                settings.NumberOr("blend_ms", 0), settings.FlagOr("follow_plan", true), settings.NumberOr("speed_share", 1),
                settings.NumberOr("acceleration_limit", double.PositiveInfinity),
                settings.NumberOr("jerk_limit", double.PositiveInfinity));
        }
        catch (InputException fault) when (!fault.Message.StartsWith(line.Place, StringComparison.Ordinal))
        {
            throw line.Wrong("settings", fault.Message);
        }
    }

    static SessionHeader.Joint ReadJoint(LineFields joint)
    {
        var (lower, upper) = (joint.NumberOr("lower", double.NegativeInfinity), joint.NumberOr("upper", double.PositiveInfinity));
        if (lower > upper) throw joint.Wrong("lower", SessionFileMessages.LimitOrder(lower, upper));
        return new SessionHeader.Joint(joint.Text("name"), joint.Text("unit"), new JointLimits(
            lower, upper, Limit(joint, "velocity"), double.PositiveInfinity, Limit(joint, "acceleration"), Limit(joint, "jerk")));
    }

    static double Limit(LineFields joint, string field)
    {
        var limit = joint.NumberOr(field, double.PositiveInfinity);
        return limit > 0 ? limit : throw joint.Wrong(field, SessionFileMessages.Limit(limit));
    }

    static SyncLine ReadSync(LineFields line)
    {
        var t4 = line.Whole("t4_ns");
        return new SyncLine(t4, new SyncExchange(
            HeadsetTime.FromNanoseconds(line.Whole("t1_ns")), ControlTime.FromNanoseconds(line.Whole("t2_ns")),
            ControlTime.FromNanoseconds(line.Whole("t3_ns")), HeadsetTime.FromNanoseconds(t4),
            line.NanosecondsOrZero("resolution_ns", MaxResolutionNs), line.NanosecondsOrZero("server_bound_ns", MaxServerBoundNs),
            line.FlagOr("server_synchronised", true)));
    }

    static SampleLine ReadSample(LineFields line)
    {
        var names = line.Texts("names");
        return new SampleLine(
            HeadsetTime.FromNanoseconds(line.Whole("arrival_ns")), ControlTime.FromNanoseconds(line.Whole("stamp_ns")), names,
            line.Numbers("position", names.Length), Optional(line, "velocity", names.Length),
            Optional(line, "acceleration", names.Length), line.TextOrNull("dropped"),
            ControlArrivalIn(line));
    }

    static PlanLine ReadPlan(LineFields line)
    {
        var names = line.Texts("names");
        var points = new List<JointTrajectoryPoint>();
        foreach (var point in line.Objects("points"))
        {
            var time = new TimeSpan(point.Whole("time_from_start_ns") / TimeSpan.NanosecondsPerTick);
            if (!JointTrajectoryPoint.CanFollow(points, time))
                throw point.Wrong("time_from_start_ns", SessionFileMessages.PointOrder(points.Count + 1));
            points.Add(new JointTrajectoryPoint(
                time, point.Numbers("position", names.Length), Optional(point, "velocity", names.Length),
                Optional(point, "acceleration", names.Length)));
        }
        var message = new JointTrajectoryMessage(ControlTime.FromNanoseconds(line.Whole("stamp_ns")), names, points);
        return new PlanLine(
            new Arrival<JointTrajectoryMessage>(message, HeadsetTime.FromNanoseconds(line.Whole("arrival_ns"))), line.TextOrNull("dropped"));
    }

    static PoseLine ReadPose(LineFields line)
    {
        var (position, rotation) = ReadPlace(line);
        var (frame, parent) = (Name(line, "frame"), Name(line, "parent"));
        if (frame == FrameParents.World) throw line.Wrong("frame", SessionFileMessages.WorldAsFrame);
        if (frame == parent) throw line.Wrong("parent", SessionFileMessages.OwnParent);
        return new PoseLine(
            ControlTime.FromNanoseconds(line.Whole("stamp_ns")), frame, parent, position, rotation, line.FlagOr("stationary", false), line.TextOrNull("dropped"),
            ControlArrivalIn(line));
    }

    static ObjectLine ReadObject(LineFields line)
    {
        var (position, rotation) = ReadPlace(line);
        return new ObjectLine(
            LightIn(line), Name(line, "frame"), rotation.At(position.X, position.Y, position.Z), line.Text("state") == "current");
    }

    static (Vector3D Position, UnitQuaternion Rotation) ReadPlace(LineFields line)
    {
        var (position, rotation) = (line.Numbers("position", 3), line.Numbers("rotation", 4));
        if (!UnitQuaternion.TryNormalise(rotation[0], rotation[1], rotation[2], rotation[3], out var turned))
            throw line.Wrong("rotation", SessionFileMessages.NotARotation);
        if (position.FirstOrDefault(value => Math.Abs(value) > TransformsReader.MaxCoordinate) is not 0 and var far)
            throw line.Wrong("position", SessionFileMessages.TooFar(far, TransformsReader.MaxCoordinate));
        return (new Vector3D(position[0], position[1], position[2]), turned);
    }

    // Returns the name of a frame, which may be a link of a robot, or of a signal.
    static string Name(LineFields line, string field)
    {
        var name = line.Text(field);
        return name.Length > 0 && RobotTopic.HasNameLength(name) ? name : throw line.Wrong(field, SessionFileMessages.Name(name, ProtocolLimits.NameLength));
    }

    static ControlTime? LightIn(LineFields line) => line.Has("light_ns") ? ControlTime.FromNanoseconds(line.Whole("light_ns")) : null;

    static ControlTime? ControlArrivalIn(LineFields line) =>
        line.Has("control_arrival_ns") ? ControlTime.FromNanoseconds(line.Whole("control_arrival_ns")) : null;

    static double[] Optional(LineFields line, string field, int count) =>
        line.Has(field) ? line.Numbers(field, count, mayBeAbsent: true) : null;
}
