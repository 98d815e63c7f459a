using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Motion;
using Nowpose.Protocol;
using Nowpose.Session;

namespace Nowpose.Simulation
{
    /// <summary>Sends the set-points of a <see cref="VirtualCell"/> in advance. Messages arrive in order. Not thread-safe.</summary>
    sealed class VirtualPlans
    {
        readonly IReadOnlyList<(string Namespace, IMotion Motion)> _robots;
        readonly VirtualClock _clock;
        readonly HeadsetTime _start;
        readonly SetPointsAhead[] _setPoints;
        readonly VirtualPath _path;
        readonly Queue<(JointTrajectoryMessage[] Messages, HeadsetTime At)> _underway = new Queue<(JointTrajectoryMessage[], HeadsetTime)>();
        HeadsetTime _next;
        HeadsetTime _inOrder;

        /// <param name="robots">The robots, whose set-points are sent at the same times.</param>
        public VirtualPlans(IReadOnlyList<(string Namespace, IMotion Motion)> robots, VirtualClock clock, int seed, HeadsetTime start)
        {
            _robots = robots;
            _clock = clock;
            _start = _next = _inOrder = start;
            _setPoints = robots.Select(robot => new SetPointsAhead(robot.Motion)).ToArray();
            _path = new VirtualPath(network => network.Down(seed), seed + 1);
        }

        /// <param name="lag">Delay of the robot behind its set-points; null to send none.</param>
        public void Run(HeadsetTime from, HeadsetTime now, TimeSpan? lag, in VirtualCellSettings settings, CompensationSession session)
        {
            if (_next < from) _next = from;
            for (; _next <= now; _next += SetPointsAhead.Interval)
                if (lag.HasValue) Send(_next, lag.Value, settings);
            while (_underway.Count > 0 && _underway.Peek().At <= now)
            {
                var (messages, at) = _underway.Dequeue();
                for (var i = 0; i < messages.Length; i++) session.Listener.Planned(messages[i], at, _robots[i].Namespace);
            }
        }

        void Send(HeadsetTime at, TimeSpan lag, in VirtualCellSettings settings)
        {
            if (!_path.TrySend(settings, out var took, out var jitter)) return;
            if (at + settings.LatencyMin + took + jitter > _inOrder) _inOrder = at + settings.LatencyMin + took + jitter;
            var (stamp, seconds) = (_clock.At(at), ClockTicks.Seconds(at + lag - _start));
            _underway.Enqueue((Array.ConvertAll(_setPoints, each => each.At(stamp, seconds)), _inOrder));
        }
    }
}
