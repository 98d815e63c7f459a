using System;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Protocol;
using Nowpose.Session.Cell;
using Nowpose.Session.Hindcast;

namespace Nowpose.Session
{
    /// <summary>One robot of a session: its received samples, its predicted joints, and the pose that is displayed.</summary>
    /// <remarks>Joints belong to their robot, so two robots may have joints with the same name.</remarks>
    sealed class SessionRobot : IRobotLinks
    {
        readonly JointTracks _tracks;
        readonly FrameComputer _computer;
        readonly DisplayedJoints _displayed;

        /// <param name="name">Namespace of the robot; empty for the robot without a namespace.</param>
        /// <param name="latency">Statistics of L_app, updated with each sample.</param>
        /// <param name="drops">Counts of dropped messages.</param>
        public SessionRobot(string name, RobotModel robot, SessionSettings settings, ApplicationLatency latency, DropCounters drops, ConnectionStart connection)
        {
            Namespace = name;
            Root = RobotTopic.Qualified(name, robot.Root.Name);
            Robot = robot;
            Description = new ReceivedDescription(robot);
            _tracks = new JointTracks(robot, settings.Prediction);
            _computer = new FrameComputer(robot, _tracks, settings.OutsideRange);
            _displayed = new DisplayedJoints(name, robot, Frame, settings.Connection.HeadsetName);
            Joints = new JointWatch(name, robot, _tracks, settings.Prediction.HorizonCap);
            Hindcast = new HindcastMonitor(robot, settings.Prediction);
            _tracks.Restarted += Hindcast.Restart;
            Intake = new SessionIntake(robot, _tracks, Hindcast, latency, drops, connection, settings.Prediction.FollowsPlans);
        }

        public string Namespace { get; }

        public RobotModel Robot { get; }

        /// <summary>Whether the robot is displayed. The state of the cell does not depend on a robot that is no longer displayed.</summary>
        public bool IsShown { get; set; } = true;

        /// <summary>Frame name of the root link, with the robot's namespace.</summary>
        public string Root { get; }

        /// <summary>Description of this robot from the gateway. Thread-safe.</summary>
        public ReceivedDescription Description { get; }

        /// <summary>
        /// Message if the gateway serves robots, but only in other namespaces; null if it does not, or if this is unknown. Set on the socket's thread.
        /// </summary>
        public string OtherNamespaces { get; set; }

        /// <summary>Queues of messages for the next frame.</summary>
        public SessionIntake Intake { get; }

        /// <summary>Detects the joints without current data.</summary>
        public JointWatch Joints { get; }

        /// <summary>Compares samples with displayed frames.</summary>
        public HindcastMonitor Hindcast { get; }

        /// <summary>Detects the joints with samples outside the robot's limits.</summary>
        public LimitWatch Limits => _tracks.Limits;

        /// <summary>The displayed frame. The next tick overwrites it.</summary>
        public DisplayFrame Frame => _computer.Frame;

        /// <summary>Displayed pose of the root link in the cell; the identity if no frame of the cell has the root link's name.</summary>
        public RigidTransform RootPose { get; private set; } = RigidTransform.Identity;

        /// <summary>Whether a frame of the cell has the root link's name. Such a frame determines the pose of the robot's base.</summary>
        public bool HasRootFrame { get; private set; }

        /// <summary>Whether the frame of the root link has the same pose at any time; false if there is no such frame.</summary>
        public bool HasFixedRootFrame { get; private set; }

        public bool IsCurrentAt(int link) => _computer.IsCurrentAt(link);

        public ReadOnlySpan<RigidTransform> Poses => Frame.LinkPoses;

        public ReadOnlySpan<RigidTransform> HeldPoses => _computer.HeldLinkPoses();

        public RigidTransform PoseAt(int link, ControlTime at, out PoseOrigin origin) => _computer.LinkPoseAt(link, at, out origin);

        /// <inheritdoc cref="FrameComputer.TryPlan"/>
        public bool TryPlan(int link, ControlTime at, out RigidTransform pose) => _computer.TryPlan(link, at, out pose);

        /// <inheritdoc cref="FrameComputer.IsMovedByJoints"/>
        public bool IsMovedByJoints(int link) => _computer.IsMovedByJoints(link);

        /// <summary>Predicts the joints to the display time of a frame.</summary>
        public void Show(in DisplayMoment moment) => _computer.Compute(moment, Joints.IsAnyReportedMissing(moment.Start));

        /// <summary>Records the frame if it is displayed; later samples give its error. Call it after <see cref="PlaceRoot"/>.</summary>
        public void Record(in DisplayMoment moment)
        {
            if (moment.IsLast) Hindcast.Shown(Frame, _tracks.Given, moment.Clock.ErrorBound, HasRootFrame && !HasFixedRootFrame);
        }

        /// <summary>Places the root link in the cell. Call it after <see cref="Show"/>.</summary>
        /// <param name="state">State of the root link's pose.</param>
        /// <param name="isFixed">Whether the root link has this pose at any time.</param>
        public void PlaceRoot(in RigidTransform pose, PoseState state, bool isFixed)
        {
            HasRootFrame = true;
            HasFixedRootFrame = isFixed;
            RootPose = pose;
            Frame.SetBase(state);
        }

        /// <inheritdoc cref="JointWatch.MissingSince"/>
        public ControlTime? MissingSince(in DisplayMoment moment) => Joints.MissingSince(moment.Start, moment.Clock, moment.DisplayTime);

        /// <summary>Writes the robot's state into a reusable object; allocates nothing.</summary>
        /// <param name="now">Headset time at which the states of the joints are evaluated.</param>
        public void Fill(RobotStatistics into, HeadsetTime now, in ClockModel clock)
        {
            into.Namespace = Namespace;
            into.Pose = Frame.State;
            into.SettledPose = Frame.SettledState;
            into.IsSettledLimitedByBase = Frame.IsSettledLimitedByBase;
            into.DescriptionMatch = Description.Match;
            into.BeyondLimits = Limits.Present;
            into.AreStampsAhead = Intake.AreStampsAhead(now);
            into.Samples = Intake.Samples;
            into.OtherNamespaces = into.Samples == 0 ? OtherNamespaces : null;
            Joints.Fill(into.JointStatuses, now, clock, Frame.DisplayTime);
        }

        /// <summary>Discards all samples, because their times are no longer valid.</summary>
        public void Restart()
        {
            _tracks.Reset();
            Hindcast.Reset();
        }

        /// <inheritdoc cref="CompensationSession.Displayed"/>
        public JointStateMessage Displayed() => _displayed.Take();
    }
}
