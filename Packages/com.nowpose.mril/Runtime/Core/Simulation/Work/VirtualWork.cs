using System;
using System.Collections.Generic;
using Nowpose.Protocol.Cell;
using Nowpose.Session;

namespace Nowpose.Simulation.Work
{
    /// <summary>Sends the objects and signals of a cell to a session. Messages arrive in order. Not thread-safe.</summary>
    sealed class VirtualWork
    {
        readonly VirtualClock _clock;
        readonly HeadsetTime _start;
        readonly WorkMessages _messages;
        readonly VirtualPath _path;
        readonly Random _random;
        readonly Queue<(TransformsMessage Frames, SignalsMessage Signals, HeadsetTime At)> _underway =
            new Queue<(TransformsMessage, SignalsMessage, HeadsetTime)>();
        // The newest value of each signal that has arrived, with its stamp. A gateway sends these to each new session.
        readonly Dictionary<string, (ControlTime Stamp, double Value)> _latched = new Dictionary<string, (ControlTime, double)>(StringComparer.Ordinal);
        HeadsetTime _lastTaken, _inOrder;
        CompensationSession _described;

        public VirtualWork(CellWork work, VirtualClock clock, int seed, HeadsetTime start)
        {
            _clock = clock;
            _start = _lastTaken = _inOrder = start;
            _messages = new WorkMessages(work);
            _path = new VirtualPath(network => network.Down(seed), seed + 1);
            _random = new Random(seed + 2);
        }

        /// <summary>Simulates the messages until now. No message is sent before <paramref name="from"/>.</summary>
        public void Run(HeadsetTime from, HeadsetTime now, in VirtualCellSettings settings, CompensationSession session)
        {
            if (_lastTaken < from)
            {
                _lastTaken = from;
                _messages.Skip();
            }
            if (_described != session) Describe(session, now);
            _described = session;
            while (_lastTaken + settings.SamplingInterval <= now) Take(_lastTaken += settings.SamplingInterval, settings);
            while (_underway.Count > 0 && _underway.Peek().At <= now)
            {
                var (frames, signals, at) = _underway.Dequeue();
                if (frames != null) session.Listener.FramesReceived(frames, isStationary: false, at);
                else Deliver(signals, session, at);
            }
        }

        void Describe(CompensationSession session, HeadsetTime now)
        {
            session.Listener.FramesReceived(_messages.Stationary(), isStationary: true, now);
            foreach (var signal in _latched)
                session.Listener.SignalsReceived(new SignalsMessage(signal.Value.Stamp, new SignalValue(signal.Key, signal.Value.Value)), now);
        }

        void Deliver(SignalsMessage signals, CompensationSession session, HeadsetTime at)
        {
            for (var i = 0; i < signals.Count; i++) _latched[signals[i].Name] = (signals.Stamp, signals[i].Value);
            session.Listener.SignalsReceived(signals, at);
        }

        // Changes of signals are never lost, because a stream retransmits lost packets.
        void Take(HeadsetTime at, in VirtualCellSettings settings)
        {
            var spread = settings.LatencyMax - settings.LatencyMin;
            var sent = at + settings.LatencyMin + new TimeSpan((long)(_random.NextDouble() * spread.Ticks));
            var isSent = _path.TrySend(settings, out var took, out var jitter);
            if (sent + took + jitter > _inOrder) _inOrder = sent + took + jitter;
            var (stamp, seconds) = (_clock.At(at), ClockTicks.Seconds(at - _start));
            foreach (var change in _messages.ChangesUntil(stamp, seconds)) _underway.Enqueue((null, change, _inOrder));
            if (isSent) _underway.Enqueue((_messages.FramesAt(stamp, seconds), null, _inOrder));
        }
    }
}
