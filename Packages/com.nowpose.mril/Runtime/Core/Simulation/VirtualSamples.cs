using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Motion;
using Nowpose.Protocol;
using Nowpose.Session;

namespace Nowpose.Simulation
{
    /// <summary>Takes, sends and delivers the samples of a <see cref="VirtualCell"/>. Not thread-safe.</summary>
    sealed class VirtualSamples
    {
        readonly IReadOnlyList<(string Namespace, IMotion Motion)> _robots;
        readonly VirtualClock _clock;
        // The joints of each robot.
        readonly string[][] _names;
        readonly HeadsetTime _start;
        readonly VirtualPath _path;
        readonly Random _random;
        // Sorted by arrival.
        readonly List<Arrival<JointStateMessage[]>> _underway = new List<Arrival<JointStateMessage[]>>(1000);
        HeadsetTime _lastTaken;
        HeadsetTime _inOrder;

        /// <param name="robots">The robots, which are sampled at the same times.</param>
        public VirtualSamples(
            IReadOnlyList<(string Namespace, IMotion Motion)> robots, VirtualClock clock, int seed, HeadsetTime start)
        {
            _robots = robots;
            _clock = clock;
            _names = robots.Select(robot => robot.Motion.JointNames.ToArray()).ToArray();
            _start = _lastTaken = _inOrder = start;
            _path = new VirtualPath(network => network.Down(seed), seed + 1);
            _random = new Random(seed + 2);
        }

        /// <summary>Simulates the samples until now. No sample is taken before <paramref name="from"/>.</summary>
        public void Run(HeadsetTime from, HeadsetTime now, in VirtualCellSettings settings, CompensationSession session)
        {
            if (_lastTaken < from) _lastTaken = from;
            while (_lastTaken + settings.SamplingInterval <= now) Take(_lastTaken += settings.SamplingInterval, settings);
            var arrived = 0;
            for (; arrived < _underway.Count && _underway[arrived].At <= now; arrived++)
                for (var i = 0; i < _robots.Count; i++)
                    session.Listener.Received(_underway[arrived].Message[i], _underway[arrived].At, _robots[i].Namespace);
            _underway.RemoveRange(0, arrived);
        }

        void Take(HeadsetTime at, in VirtualCellSettings settings)
        {
            var spread = settings.LatencyMax - settings.LatencyMin;
            var sent = at + settings.LatencyMin + new TimeSpan((long)(_random.NextDouble() * spread.Ticks));
            if (!_path.TrySend(settings, out var took, out var jitter)) return;
            // On a stream, a sample does not arrive before the previous sample.
            if (sent + took > _inOrder) _inOrder = sent + took;
            var messages = new JointStateMessage[_robots.Count];
            for (var i = 0; i < messages.Length; i++) messages[i] = Sample(i, at);
            Enqueue(new Arrival<JointStateMessage[]>(messages, _inOrder + jitter));
        }

        JointStateMessage Sample(int robot, HeadsetTime at)
        {
            var positions = new double[_names[robot].Length];
            _robots[robot].Motion.At(ClockTicks.Seconds(at - _start), positions);
            return new JointStateMessage(_clock.At(at), _names[robot], positions);
        }

        void Enqueue(in Arrival<JointStateMessage[]> arrival)
        {
            var place = _underway.Count;
            while (place > 0 && _underway[place - 1].At > arrival.At) place--;
            _underway.Insert(place, arrival);
        }
    }
}
