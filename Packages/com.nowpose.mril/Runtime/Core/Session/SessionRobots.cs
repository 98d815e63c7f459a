using System;
using System.Collections;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session.Cell;

namespace Nowpose.Session
{
    /// <summary>
    /// Robots of a session, the main robot first. Add and show robots on the thread of <see cref="CompensationSession.Tick"/>; other members
    /// are thread-safe.
    /// </summary>
    sealed class SessionRobots : IReadOnlyList<SessionRobot>
    {
        /// <summary>Maximum age of a frame whose poses are displayed; longer than the stalls of a headset that goes on.</summary>
        static readonly TimeSpan MaxFrameAge = TimeSpan.FromSeconds(1);

        readonly SessionSettings _settings;
        readonly ApplicationLatency _latency;
        readonly DropCounters _drops;
        readonly SessionFrames _frames;
        readonly Subscriptions _subscriptions;
        readonly ConnectionStart _connection;
        readonly object _gate;
        // The array is replaced when a robot is added, and never modified, because network threads read it.
        volatile SessionRobot[] _all = Array.Empty<SessionRobot>();

        /// <param name="latency">Statistics of L_app, updated with each sample.</param>
        /// <param name="drops">Counts of dropped messages.</param>
        /// <param name="frames">Objects of the cell, to which the robots' links are added.</param>
        /// <param name="gate">Lock of the session.</param>
        public SessionRobots(
            SessionSettings settings, ApplicationLatency latency, DropCounters drops, SessionFrames frames, Subscriptions subscriptions,
            ConnectionStart connection, object gate)
        {
            _settings = settings;
            _latency = latency;
            _drops = drops;
            _frames = frames;
            _subscriptions = subscriptions;
            _connection = connection;
            _gate = gate;
        }

        /// <summary>Raised within <see cref="Add"/> with the new robot, before the session uses its first message.</summary>
        public event Action<SessionRobot> Added;

        public int Count => _all.Length;

        public SessionRobot this[int index] => _all[index];

        /// <summary>Adds a robot to the cell. From then on, the session receives and shows it.</summary>
        /// <param name="name">Namespace of the robot; empty for the robot without a namespace.</param>
        /// <returns>The new robot, or the existing robot if it has the same namespace and the same description.</returns>
        /// <exception cref="InputException">The namespace is invalid, another robot has it, or the cell has the maximum number of robots in namespaces.</exception>
        public SessionRobot Add(string name, RobotModel robot)
        {
            if (name.Length > 0) RobotTopic.RequireNamespace(name);
            var known = Of(name);
            if (known?.Robot.SourceHash == robot.SourceHash) return known;
            if (known != null) throw new InputException(RobotMessages.NamespaceTaken(name, known.Robot.Name));
            // Of("") is the robot without a namespace, which the limit does not count.
            if (name.Length > 0 && _all.Length - (Of("") == null ? 0 : 1) >= ProtocolLimits.Robots)
                throw new InputException(RobotMessages.TooManyRobots(name, ProtocolLimits.Robots));
            var added = new SessionRobot(name, robot, _settings, _latency, _drops, _connection);
            lock (_gate)
            {
                _frames.Add(added);
                _all = new List<SessionRobot>(_all) { added }.ToArray();
            }
            Added?.Invoke(added);
            _subscriptions.AddRobot(name);
            return added;
        }

        /// <summary>Returns the robot with the given namespace; null if the session has no such robot.</summary>
        public SessionRobot Of(string name)
        {
            foreach (var robot in _all)
                if (robot.Namespace == name) return robot;
            return null;
        }

        /// <summary>The most severe state among the poses of all displayed robots. Call it under the lock of the session.</summary>
        public PoseState WorstPose
        {
            get
            {
                var worst = PoseState.Current;
                foreach (var robot in _all)
                    if (robot.IsShown && robot.Frame.State < worst) worst = robot.Frame.State;
                return worst;
            }
        }

        /// <summary>
        /// Returns the time for which no frame has been computed, if the poses of the newest frame are no longer current for this reason: the program loads a
        /// scene, or hangs. Null if they are current, or not current for another reason. Call it under the lock of the session.
        /// </summary>
        public TimeSpan? FramesMissingFor(HeadsetTime now)
        {
            var age = now - _all[0].Frame.Start;
            return age > MaxFrameAge && WorstPose > PoseState.Held ? age : (TimeSpan?)null;
        }

        /// <summary>Returns <see cref="WorstPose"/>, or held if no frames are computed. Call it under the lock of the session.</summary>
        public PoseState WorstPoseAt(HeadsetTime now) => FramesMissingFor(now) == null ? WorstPose : PoseState.Held;

        /// <summary>Processes all messages that have arrived.</summary>
        public void Take(in ClockModel clock)
        {
            foreach (var robot in _all) robot.Intake.TakeAll(clock);
        }

        public void Show(in DisplayMoment moment)
        {
            foreach (var robot in _all) robot.Show(moment);
        }

        /// <summary>Places each robot at the frame of the cell that has its root link's name, and records its frame there.</summary>
        public void PlaceRoots(in DisplayMoment moment)
        {
            foreach (var robot in _all)
            {
                _frames.PlaceRoot(robot);
                robot.Record(moment);
            }
        }

        /// <summary>Discards all samples, because their times are no longer valid.</summary>
        public void Restart()
        {
            foreach (var robot in _all) robot.Restart();
        }

        public IEnumerator<SessionRobot> GetEnumerator() => ((IEnumerable<SessionRobot>)_all).GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
    }
}
