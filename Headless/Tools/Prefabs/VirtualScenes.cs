using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Samples;
using Nowpose.Simulation.Work;

namespace Nowpose.Prefabs;

/// <summary>Creates the scenes with a simulated control system. They also draw the real arms, which hide the virtual parts behind them.</summary>
sealed class VirtualScenes
{
    /// <summary>Namespace of the session's own robot in the cell with two arms.</summary>
    public const string FirstArm = "arm1";

    readonly PackageAssets _assets;
    readonly RobotDescriptionAsset _description;
    readonly RobotModel _robot;
    readonly PickAndPlaceMotion _motion;
    readonly CellWork _work;
    readonly GameObject _cell;
    readonly MrilSession _session;
    readonly SimulatedControlSystem _control;

    /// <param name="robots">Number of robots, 1 or 2.</param>
    VirtualScenes(PackageAssets assets, string settingsPath, int robots)
    {
        _assets = assets;
        _description = assets.Load<RobotDescriptionAsset>(PackagePaths.Youbot);
        _robot = _description.Read();
        _motion = new PickAndPlaceMotion(_robot);
        _work = new CellWork(_robot, _motion, robots);
        _cell = Scenes.Cell(assets, PackagePaths.Cell, settingsPath);
        _session = _cell.GetComponent<MrilSession>();
        Fields.Set(_session, "_connectOnEnable", false);
        _control = new GameObject("Simulated Control System").AddComponent<SimulatedControlSystem>();
        Fields.Set(_control, "_session", _session);
        Fields.Set(_control, "_robot", _description);
    }

    public static string OneArm(PackageAssets assets)
    {
        var made = new VirtualScenes(assets, PackagePaths.VirtualSettings, robots: 1);
        made.Complete(Scenes.DisplayedIn(made._cell), made._work.Robots[0]);
        return Scenes.Desktop(
            assets, Scenes.InFront(), made._control.gameObject, made.Real("Real Robot", made._work.Robots[0]), made._cell, made.Objects());
    }

    /// <summary>Creates a scene in which two arms share a conveyor. The second arm is an instance of the robot prefab.</summary>
    public static string TwoArms(PackageAssets assets)
    {
        var made = new VirtualScenes(assets, PackagePaths.TwoArmsSettings, robots: 2);
        Fields.Set(made._control, "_hasSecondRobot", true);
        Fields.Set(made._control, "_publishesSetPoints", true);
        made.Complete(Scenes.DisplayedIn(made._cell), made._work.Robots[0]);
        made.AddSecondRobot(made._work.Robots[1]);
        var beside = Props.Camera(new Vector3(1.25f, 0.75f, 0.35f), new Vector3(25, -90, 0));
        return Scenes.Desktop(
            assets, beside, made._control.gameObject, made.Real("Real Robot", made._work.Robots[0]), made.Real("Real Robot 2", made._work.Robots[1]),
            made._cell, made.Objects());
    }

    void AddSecondRobot(WorkRobot robot)
    {
        var made = _assets.Instantiate(PackagePaths.Robot, _cell.GetComponentInChildren<BaseAnchor>(includeInactive: true).transform);
        made.name = "Second Robot";
        foreach (var rig in made.GetComponentsInChildren<RobotRig>(includeInactive: true))
        {
            Fields.Set(rig, "_session", _session);
            Fields.Set(rig, "_robotNamespace", robot.Namespace);
            Fields.Set(rig.GetComponent<PoseAppearance>(), "_session", _session);
        }
        Complete(made.transform.Find("Robot").GetComponent<RobotRig>(), robot);
    }

    // The real arm is visible, so that its virtual copy is not needed.
    void Complete(RobotRig displayed, WorkRobot robot)
    {
        foreach (var part in Scenes.Arm(_assets, displayed)) part.enabled = false;
        displayed.transform.parent.Find("Ghost").gameObject.SetActive(true);
        FollowSignal(displayed.GetComponentInChildren<VirtualGripper>(includeInactive: true), robot.GripperClosed);
        AddPlannedPath(displayed);
    }

    // Makes the fingers move with the signal of the gripper instead of the finger joints.
    void FollowSignal(VirtualGripper gripper, string signal)
    {
        foreach (var (name, finger) in Fields.Get<List<GripperFinger>>(gripper, "_fingers").Select(each => (each.Joint, each.Finger)))
        {
            var index = _robot.IndexOfMovingJoint(name);
            var (open, closed) = (PositionAt(_motion.Task.Grip, 0, index), PositionAt(_motion.Task.Release, 0, index));
            var drive = new JointDrive(finger, _robot.MovingJoints[index], finger.localPosition, finger.localRotation);
            drive.Apply(closed);
            var end = finger.localPosition;
            drive.Apply(open);
            var part = finger.gameObject.AddComponent<ActuatedPart>();
            Fields.Set(part, "_session", _session);
            Fields.Set(part, "_signal", signal);
            Fields.Set(part, "_wayMetres", TransformRounding.Rounded(end - finger.localPosition));
            Fields.Set(part, "_strokeMs", StrokeMs(index, closed));
        }
        Fields.Set(gripper, "_fingers", new List<GripperFinger>());
        TransformRounding.Apply(gripper.transform);
    }

    double PositionAt(int move, double seconds, int joint)
    {
        var positions = new double[_robot.MovingJoints.Count];
        _motion.At(move, seconds, positions);
        return positions[joint];
    }

    // Returns the time that the finger of the simulated robot needs to close, in whole ms.
    float StrokeMs(int joint, double closed)
    {
        var ms = 0;
        while (Math.Abs(PositionAt(_motion.Task.Grip, ms / 1000.0, joint) - closed) > 1e-6) ms++;
        return ms;
    }

    void AddPlannedPath(RobotRig displayed)
    {
        var path = Children.Add("Planned Path", displayed.transform);
        Fields.Set(path.AddComponent<PlannedPath>(), "_rig", displayed);
        path.GetComponent<LineRenderer>().sharedMaterial = _assets.Load<Material>(PackagePaths.Ghost);
    }

    GameObject Real(string name, WorkRobot robot)
    {
        var solid = _assets.Load<Material>(PackagePaths.Solid);
        var real = Rigs.Build(_description, null, solid, solid);
        real.name = name;
        var place = UnityPoses.ToWorld(robot.Base);
        real.transform.SetPositionAndRotation(place.position, place.rotation);
        var truth = real.gameObject.AddComponent<TruthRig>();
        Fields.Set(truth, "_controlSystem", _control);
        Fields.Set(truth, "_isSecondRobot", robot != _work.Robots[0]);
        TransformRounding.Apply(real.transform);
        return real.gameObject;
    }

    GameObject Objects() => WorkObjects.Build(_assets, _session, _work);
}
