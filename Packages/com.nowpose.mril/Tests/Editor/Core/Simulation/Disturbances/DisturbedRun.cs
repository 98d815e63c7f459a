using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;

namespace Nowpose.Tests.Core.Simulation.Disturbances
{
    /// <summary>
    /// Runs a session in virtual time while its cell, network and clocks are disturbed. Checks that what a frame states as current is near the truth,
    /// and that everything is current again some time after the last disturbance.
    /// </summary>
    sealed class DisturbedRun
    {
        const double Visualisation = 0.04, SamplingInterval = 0.05;

        /// <summary>Time from the last disturbance until everything must be current, and time for which it must remain so, s.</summary>
        const double RecoverySeconds = 15, CalmSeconds = 5;

        /// <summary>Time after a step of the clock in which poses may be wrong, s: until exchanges show the step.</summary>
        const double StepSeconds = 0.8;

        /// <summary>
        /// Maximum error of a current pose relative to the distance that it has moved since its newest sample: a motion may reverse. Plus 20 mm for
        /// the blend.
        /// </summary>
        const double MaxErrorRatio = 2.5, MaxBlendError = 0.02;

        /// <summary>Maximum error of the display time in addition to the stated one, which a line through few exchanges may exceed.</summary>
        static readonly TimeSpan MaxTimeError = Lengths.Ms(10);

        static readonly HeadsetTime Start = HeadsetTime.FromSeconds(500);
        static readonly string[] Objects = { DisturbedCell.Cart, DisturbedCell.Part, DisturbedCell.Fixture, DisturbedCell.Tag };

        readonly List<Disturbance> _disturbances;
        readonly DisturbedCell _cell;
        readonly DisturbedClock _clock;
        readonly CompensationSession _session;
        readonly DisturbedNetwork _network;
        readonly DisturbedSignal _signal;
        readonly List<string> _faults = new List<string>();
        JointStateMessage _newest;
        double _nextSample, _newestTool, _newestObjects;

        public DisturbedRun(int seed)
        {
            var random = new Random(seed);
            _disturbances = Disturbance.Some(random);
            (_cell, _clock) = (new DisturbedCell(seed), new DisturbedClock(Start, _disturbances));
            var settings = new SessionSettings(new ConnectionSettings("127.0.0.1"), new VisualisationLatency(Lengths.Seconds(Visualisation)));
            _session = new CompensationSession(settings, _cell.Robot, new StopwatchHeadsetClock());
            _network = new DisturbedNetwork(_session, _clock, _disturbances, random);
            _network.Connected += Connect;
            _signal = new DisturbedSignal(seed, _clock);
            _session.Signals.Need(DisturbedSignal.Name);
            foreach (var name in Objects) _session.Frames.Need(name);
        }

        /// <summary>Returns what was wrong.</summary>
        public IEnumerable<string> Run()
        {
            var calm = _disturbances.Max(one => one.End) + RecoverySeconds;
            for (var now = 0.0; now < calm + CalmSeconds; now += _disturbances.Active(DisturbanceKind.SlowFrames, now)?.Size ?? 1 / 60.0)
            {
                _clock.Run(now);
                for (; _nextSample <= now; _nextSample += _disturbances.Active(DisturbanceKind.OtherInterval, _nextSample)?.Size ?? SamplingInterval)
                    Sample(_nextSample);
                while (_signal.Next <= now) _network.Send(_signal.Next, _signal.Change(_session));
                _network.Run(now);
                if (!_network.IsAsleep(now)) Check(_session.Tick(_clock.HeadsetAt(now)), now, isCalm: now >= calm);
            }
            return _faults.Select(fault => fault + " (" + string.Join("; ", _disturbances) + ")");
        }

        void Connect(double now)
        {
            var at = _clock.HeadsetAt(now);
            _session.Listener.Connected(at);
            var poses = new TransformsMessage(
                DisturbedCell.FixturePose.ToTransform(default, FrameParents.World, DisturbedCell.Fixture),
                DisturbedCell.TagPose.ToTransform(default, DisturbedCell.Cart, DisturbedCell.Tag));
            _session.Listener.FramesReceived(poses, isStationary: true, at);
            _signal.SendAgain(_session, at, now);
        }

        void Sample(double time)
        {
            if (!_disturbances.Has(DisturbanceKind.SilentJoints, time))
            {
                var joints = _disturbances.Has(DisturbanceKind.SomeJoints, time) ? 2 : _cell.JointNames.Length;
                var isRepeated = _disturbances.Has(DisturbanceKind.RepeatedJoints, time);
                var message = isRepeated ? _newest : new JointStateMessage(
                    _clock.ControlAt(time), _cell.JointNames.Take(joints).ToArray(), _cell.Joints(time).Take(joints).ToArray());
                _newest = message;
                _network.Send(time, at =>
                {
                    _session.Listener.Received(message, at);
                    if (!isRepeated && joints > 2) _newestTool = Math.Max(_newestTool, time);
                });
            }
            if (_disturbances.Has(DisturbanceKind.SilentObjects, time)) return;
            var (stamp, part) = (_clock.ControlAt(time), _cell.PartOnCarrier(time, out var carrier));
            var cart = _cell.World(DisturbedCell.Cart, time);
            if (_disturbances.Has(DisturbanceKind.UnknownParent, time)) carrier = "unknown";
            _network.Send(time, at =>
            {
                var message = new TransformsMessage(
                    cart.ToTransform(stamp, FrameParents.World, DisturbedCell.Cart), part.ToTransform(stamp, carrier, DisturbedCell.Part));
                _session.Listener.FramesReceived(message, isStationary: false, at);
                _newestObjects = Math.Max(_newestObjects, time);
            });
        }

        void Check(DisplayFrame frame, double now, bool isCalm)
        {
            if (_clock.HasSteppedWithin(StepSeconds, now)) return;
            if (frame.State == PoseState.Current) CheckTime(frame, now);
            CheckSignal(now, isCalm);
            Check(DisturbedCell.Gripper, frame.State, frame.ToolPose, _newestTool, now, isCalm);
            foreach (var name in Objects)
            {
                var shown = _session.Frames.Find(name);
                var newest = name == DisturbedCell.Part ? Math.Min(_newestObjects, _newestTool) : _newestObjects;
                Check(name, _session.Frames.StateOf(shown), shown?.World ?? default, newest, now, isCalm);
            }
        }

        void CheckSignal(double now, bool isCalm)
        {
            var fault = _session.Signals.FaultOf(DisturbedSignal.Name, isConnected: true).Reason;
            var value = _session.Signals.Table.Find(DisturbedSignal.Name)?.Value ?? double.NaN;
            if (fault == null && !_signal.MayBe(value, now + Visualisation)) _faults.Add($"{now:0.00} s: the signal is current, but wrong: {value}");
            if (fault != null && isCalm) _faults.Add($"{now:0.00} s: the signal is still not current: {fault}");
        }

        void CheckTime(DisplayFrame frame, double now)
        {
            var error = (frame.DisplayTime.Value - _clock.ControlAt(now + Visualisation)).Duration();
            if (error > frame.ClockError + MaxTimeError) _faults.Add($"{now:0.00} s: the display time is wrong by {error.TotalMilliseconds:0} ms");
        }

        void Check(string name, PoseState state, in RigidTransform shown, double newest, double now, bool isCalm)
        {
            if (state != PoseState.Current)
            {
                if (isCalm) _faults.Add($"{now:0.00} s: {name} is still {state}");
                return;
            }
            var light = now + Visualisation;
            var error = DisturbedCell.Distance(shown, _cell.World(name, light));
            if (error <= MaxBlendError) return;
            var allowed = MaxBlendError + MaxErrorRatio * _cell.Reach(name, light, light - newest + PoseFade.Seconds);
            if (error > allowed) _faults.Add($"{now:0.00} s: {name} is current, but wrong by {1000 * error:0} mm (allowed {1000 * allowed:0})");
        }
    }
}
