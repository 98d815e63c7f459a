using System;
using System.Collections.Generic;
using Nowpose.Motion;
using Nowpose.Protocol;
using Nowpose.Session;

namespace Nowpose.Simulation
{
    /// <summary>Sends the set-points of a <see cref="VirtualCell"/> in advance. Messages arrive in order. Not thread-safe.</summary>
    sealed class VirtualPlans
    {
        readonly string[] _robots;
        readonly VirtualClock _clock;
        readonly HeadsetTime _start;
        readonly SetPointsAhead _setPoints;
        readonly VirtualPath _path;
        readonly Queue<(JointTrajectoryMessage Message, HeadsetTime At)> _underway = new Queue<(JointTrajectoryMessage, HeadsetTime)>();
        HeadsetTime _next;
        HeadsetTime _inOrder;

        /// <param name="robots">Namespaces of the robots, which all have this motion.</param>
        public VirtualPlans(IMotion motion, string[] robots, VirtualClock clock, int seed, HeadsetTime start)
        {
            _robots = robots;
            _clock = clock;
            _start = _next = _inOrder = start;
            _setPoints = new SetPointsAhead(motion);
            _path = new VirtualPath(network => network.Down(seed), seed + 1);
        }

        /// <param name="lag">Delay of the robot behind its set-points.</param>
        public void Run(HeadsetTime from, HeadsetTime now, TimeSpan lag, in VirtualCellSettings settings, CompensationSession session)
        {
            if (_next < from) _next = from;
            for (; _next <= now; _next += SetPointsAhead.Interval) Send(_next, lag, settings);
            while (_underway.Count > 0 && _underway.Peek().At <= now)
            {
                var (message, at) = _underway.Dequeue();
                foreach (var robot in _robots) session.Listener.Planned(message, at, robot);
            }
        }

        void Send(HeadsetTime at, TimeSpan lag, in VirtualCellSettings settings)
        {
            if (!_path.TrySend(settings, out var took, out var jitter)) return;
            if (at + settings.LatencyMin + took + jitter > _inOrder) _inOrder = at + settings.LatencyMin + took + jitter;
            _underway.Enqueue((_setPoints.At(_clock.At(at), ClockTicks.Seconds(at + lag - _start)), _inOrder));
        }
    }
}
