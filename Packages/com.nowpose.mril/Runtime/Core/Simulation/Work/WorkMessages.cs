using System;
using System.Collections.Generic;
using Nowpose.Frames;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Simulation.Work
{
    /// <summary>Messages of a cell's objects and signals, as its control system publishes them. Not thread-safe.</summary>
    /// <remarks>A message of signals has the stamp of the control cycle in which they changed.</remarks>
    sealed class WorkMessages
    {
        readonly CellWork _work;
        readonly double[] _now, _sent;
        CellState _newest;
        bool _hasSkipped;

        public WorkMessages(CellWork work)
        {
            _work = work;
            _now = new double[work.Signals.Count];
            _sent = new double[work.Signals.Count];
        }

        /// <summary>Returns the poses of the stationary frames, which are valid at all times.</summary>
        public TransformsMessage Stationary()
        {
            var message = new TransformsMessage();
            message.Add(_work.ConveyorPose.ToTransform(default, FrameParents.World, CellWork.Conveyor));
            foreach (var robot in _work.Robots)
            {
                message.Add(robot.FixturePose.ToTransform(default, FrameParents.World, robot.Fixture));
                if (robot.Namespace.Length > 0) message.Add(robot.Base.ToTransform(default, FrameParents.World, robot.Root));
            }
            return message;
        }

        /// <summary>Returns the poses of all workpieces.</summary>
        /// <param name="seconds">Time since the start of the robot's motion at the stamp, s.</param>
        public TransformsMessage FramesAt(ControlTime stamp, double seconds)
        {
            var transforms = new FrameTransform[_work.Names.Count];
            for (var i = 0; i < transforms.Length; i++)
                transforms[i] = _work.PoseOf(i, seconds, out var parent).ToTransform(stamp, parent, _work.Names[i]);
            return new TransformsMessage(transforms);
        }

        /// <summary>
        /// Returns one message for each control cycle since the last call in which signals changed; the first call returns the values of all signals.
        /// </summary>
        /// <inheritdoc cref="FramesAt"/>
        public IEnumerable<SignalsMessage> ChangesUntil(ControlTime stamp, double seconds)
        {
            var isFirst = _newest == null;
            if (isFirst || _hasSkipped)
            {
                (_newest, _hasSkipped) = (_work.StateAt(seconds), false);
                var message = MessageOf(_newest, stamp, isFirst);
                if (message != null) yield return message;
            }
            for (var next = _work.Next(_newest, seconds); next != null; next = _work.Next(next, seconds))
            {
                _newest = next;
                var message = MessageOf(next, stamp - ClockTicks.Span(seconds - next.Cycle * CellState.CycleSeconds), isFirst: false);
                if (message != null) yield return message;
            }
        }

        /// <summary>Skips the changes until the next call of <see cref="ChangesUntil"/>, which then returns the values that differ from those before.</summary>
        public void Skip() => _hasSkipped = true;

        // Returns null if no signal differs from its last value.
        SignalsMessage MessageOf(CellState state, ControlTime stamp, bool isFirst)
        {
            state.GetSignals(_now);
            List<SignalValue> changed = null;
            for (var i = 0; i < _now.Length; i++)
                if (isFirst || _now[i] != _sent[i]) (changed ??= new List<SignalValue>()).Add(new SignalValue(_work.Signals[i], _now[i]));
            _now.CopyTo(_sent, 0);
            return changed == null ? null : new SignalsMessage(stamp, changed.ToArray());
        }
    }
}
