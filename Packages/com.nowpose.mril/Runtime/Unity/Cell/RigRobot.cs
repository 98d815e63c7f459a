using System;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Unity.Cell
{
    /// <summary>
    /// The robot of a session that a rig shows: the session's own robot, or a robot in a namespace, which this class adds to each session.
    /// </summary>
    sealed class RigRobot : IShownPart
    {
        readonly RobotRig _rig;
        readonly string _name;
        readonly RobotDescriptionAsset _description;
        readonly MrilSession _source;
        readonly JointStatusLine _missingJoints = new JointStatusLine(isOfMissing: true, () => DateTime.Now);
        CompensationSession _session;
        SessionRobot _robot;
        string _sameRobot;
        // While the settled state is held, the joints may have data in some frames.
        ControlTime? _heldSince;
        bool _isHeldByBase;

        /// <param name="name">Namespace of the robot; empty for the session's own robot.</param>
        /// <param name="description">Description of a robot in a namespace; not used for the session's own robot.</param>
        /// <param name="source">The component that has the session. A robot in a namespace is listed among the parts of this component; the
        /// session's own robot is not.</param>
        public RigRobot(RobotRig rig, string name, RobotDescriptionAsset description, MrilSession source)
        {
            _source = source;
            Title = "robot " + (name.Length == 0 ? rig.name : name);
            _rig = rig;
            FindWorld();
            _name = name;
            _description = description;
            source.Robots.Add(this);
            if (IsListed) source.Parts.Add(this);
        }

        /// <summary>Whether the rig shows the pose at the display time, and not the newest samples for comparison.</summary>
        public bool IsDisplayed => _rig.Shows == RigPose.Displayed;

        public string Title { get; }

        public string Fault
        {
            get
            {
                if (_session != null && HasEnded) return StatusMessages.NoSession;
                if (_robot == null) return _session == null ? StatusMessages.NoSession : StatusMessages.RobotNotAdded;
                return FaultOf(_robot.Frame) ?? (HasLostBase ? BaseMessages.Destroyed : null) ?? (IsSecond ? _sameRobot : null)
                    ?? (StatisticsOf(_source.Statistics) is RobotStatistics robot ? FaultOf(robot) : ReasonOf(_robot.Frame.SettledState));
            }
        }

        public bool IsFaultCommon => _robot != null && !HasEnded
            && (_robot.Frame.SettledState == PoseState.Unsynchronised || _robot.Frame.SettledState == PoseState.OutsideRange);

        public ControlTime? FaultSince
        {
            get
            {
                if (_robot == null || HasEnded || _robot.Frame.SettledState == PoseState.Current) return null;
                return _heldSince ?? SinceNow;
            }
        }

        ControlTime? SinceNow => _robot.Frame.IsSettledLimitedByBase
            ? _session.Frames.HeldSince(_session.Frames.Find(_robot.Root)) : _session.Frames.MissingSince(_robot);

        // The states in a session that has ended are those of its last frame.
        bool HasEnded => _source.Session != _session;

        // The time and the render time concern the whole cell, and a base that is not current concerns all joints.
        static string FaultOf(DisplayFrame frame) =>
            frame.IsSettledLimitedByBase || frame.SettledState == PoseState.Unsynchronised || frame.SettledState == PoseState.OutsideRange
                ? StatusMessages.ReasonOf(frame.SettledState, frame.IsSettledLimitedByBase) : null;

        string FaultOf(RobotStatistics robot) => robot.OtherNamespaces ?? _missingJoints.Of(robot)
            ?? ReasonOf(robot.SettledPose)
            ?? robot.SampleProblem
            ?? (robot.DescriptionMatch == RobotDescriptionMatch.Different ? RobotMessages.DescriptionDiffers : null);

        static string ReasonOf(PoseState state) => state == PoseState.Current ? null : StatusMessages.ReasonOf(state);

        RobotStatistics StatisticsOf(SessionStatistics session)
        {
            for (var i = 0; i < (session?.OtherRobots.Count ?? 0); i++)
                if (session.OtherRobots[i].Namespace == _name) return session.OtherRobots[i];
            return null;
        }

        // A rig that shows the newest samples for comparison is not listed, because its pose is never current.
        bool IsListed => !IsOwn && IsDisplayed;

        // Whether another rig shows the same robot. It is then probably the wrong one for this rig.
        bool IsSecond => _sameRobot != null && _source.Robots.FirstDisplayed(_robot, _session) != this;

        // The rig follows the base, but its frame was destroyed.
        bool HasLostBase => World == null && _robot != null && _robot.HasRootFrame;

        bool IsOwn => _name.Length == 0;

        /// <summary>Model of the robot; null while it is unknown.</summary>
        public RobotModel Model => IsOwn ? _source.Robot : _robot?.Robot;

        /// <summary>The robot in the session of the last frame; null while the session has no such robot.</summary>
        public SessionRobot Robot => _robot;

        /// <summary>The transform that is the frame <c>world</c>; equal to null if it was destroyed. The base then stays where it is.</summary>
        public Transform World { get; private set; }

        /// <summary>Returns the state that the robot's look shows in a frame of the session.</summary>
        public PoseState StateIn(DisplayFrame frame)
        {
            var state = IsOwn ? _source.StateIn(frame) : _robot == null ? PoseState.Incomplete : _robot.Frame.SettledState;
            return HasLostBase ? CellPlace.StateIn(World, state) : state;
        }

        /// <summary>Returns the robot that this rig shows in a session; null if it has not been added.</summary>
        public SessionRobot RobotIn(CompensationSession session) => IsOwn ? session.Robots[0] : session.Robots.Of(_name);

        /// <summary>Finds the robot in the session, or adds it, and returns its display frame.</summary>
        /// <param name="frame">Display frame of the session's own robot.</param>
        /// <returns>Null if the robot could not be added.</returns>
        public DisplayFrame FrameIn(CompensationSession session, DisplayFrame frame)
        {
            if (session != _session)
            {
                _session = session;
                _robot = IsOwn ? RobotIn(session) : Add(session);
                CompareWithOthers();
            }
            SetShown(true);
            KeepSince();
            return IsOwn ? frame : _robot?.Frame;
        }

        void KeepSince()
        {
            if (!IsListed || _robot == null) return;
            var isHeld = _robot.Frame.SettledState == PoseState.Held;
            if (!isHeld || _robot.Frame.IsSettledLimitedByBase != _isHeldByBase) _heldSince = null;
            _isHeldByBase = _robot.Frame.IsSettledLimitedByBase;
            if (isHeld) _heldSince ??= SinceNow;
        }

        /// <summary>Finds the frame <c>world</c>. Call it when the rig or one of its parents has got a new parent.</summary>
        public void FindWorld() => World = CellPlace.WorldOf(_rig, _source);

        /// <summary>Removes the robot from the session's parts.</summary>
        public void Leave()
        {
            _source.Parts.Remove(this);
            _source.Robots.Remove(this);
            SetShown(false);
        }

        // The session's own robot always counts for the state of the cell, also if a rig shows it by its namespace.
        void SetShown(bool isShown)
        {
            if (IsListed && _robot != null && _robot != _session.Robots[0]) _robot.IsShown = isShown;
        }

        /// <summary>Moves the rig to the robot's base if the cell has a frame with the name of the robot's root link.</summary>
        /// <returns>Whether the cell has this frame.</returns>
        public bool PlaceBase()
        {
            if (_robot == null || !_robot.HasRootFrame || World == null) return false;
            var tree = _session.Frames.Tree;
            _rig.transform.PlaceIn(World, _rig.Shows == RigPose.Held ? tree.HeldOf(tree.IndexOf(_robot.Root)) : _robot.RootPose);
            return true;
        }

        // Runs in the first frame, because a script may set the namespace after it has added the rig.
        void CompareWithOthers()
        {
            if (_robot == null || !IsDisplayed || _sameRobot != null) return;
            if (!(_source.Robots.FirstDisplayed(_robot, _session) is RigRobot first) || first == this) return;
            _sameRobot = RigMessages.SameRobot(first._rig.name);
            ConsoleLog.Warn(_rig, ComponentMessages.Of("rig", _rig.name, _sameRobot));
            if (IsOwn) _source.Parts.Add(this);
        }

        SessionRobot Add(CompensationSession session)
        {
            try
            {
                if (_description == null)
                    throw new InputException(RigMessages.NoDescription(_name, _rig.name));
                // For the same URDF, the rig keeps its model, and with it the links that it has built and the user's objects below them.
                var shown = _rig.Model;
                return session.Robots.Add(_name, shown?.SourceHash == UrdfHash.Of(_description.Urdf) ? shown : _description.Read());
            }
            catch (InputException fault)
            {
                ConsoleLog.Fail(_rig, fault.Message);
                return null;
            }
        }
    }
}
