using System;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Simulation
{
    /// <summary>The sync exchanges of a <see cref="VirtualCell"/>: one at a time, as over TCP. Not thread-safe.</summary>
    sealed class VirtualExchanges
    {
        static readonly TimeSpan LostInterval = ClockTicks.Span(ProtocolLimits.SyncIntervalMs / 1000);

        /// <summary>Time from a request's arrival until its reply is sent.</summary>
        static readonly TimeSpan Turnaround = new TimeSpan(200);

        readonly VirtualClock _clock;
        readonly int _paceSeed;
        readonly VirtualPath _up;
        readonly VirtualPath _down;
        SyncExchange? _underway;
        HeadsetTime _begun;
        HeadsetTime _next;
        CompensationSession _session;
        ExchangePace _pace;

        public VirtualExchanges(VirtualClock clock, int seed, HeadsetTime start)
        {
            _clock = clock;
            _paceSeed = seed + 4;
            _up = new VirtualPath(network => network.Up(seed), seed + 1);
            _down = new VirtualPath(network => network.Down(seed + 2), seed + 3);
            _next = start;
        }

        /// <summary>Simulates the exchanges until now. No exchange begins before <paramref name="from"/>.</summary>
        public void Run(HeadsetTime from, HeadsetTime now, in VirtualCellSettings settings, CompensationSession session)
        {
            if (_session != session)
            {
                // A new session has a new connection, so an exchange of the previous session is discarded.
                if (_session != null) _next = now;
                _underway = null;
                _session = session;
                _pace = session.Settings.NewExchangePace(new Random(_paceSeed));
            }
            if (_next < from) _next = from;
            while (true)
            {
                if (_underway?.T4 <= now) Deliver(session);
                if (_underway.HasValue || _next > now) return;
                Begin(settings);
            }
        }

        void Deliver(CompensationSession session)
        {
            if (session.Clock.Add(_underway.Value, out var fault) == SyncVerdict.SetAside)
                session.SyncFaults.Count(SyncExchangeFault.Contradiction);
            session.SyncFaults.Count(fault);
            var ended = _underway.Value.T4;
            _next = _begun + _pace.Next(session.Clock, ended);
            // The next exchange starts when it is due, but not before this exchange has ended.
            if (_next < ended) _next = ended;
            _underway = null;
        }

        void Begin(in VirtualCellSettings settings)
        {
            var t1 = _begun = _next;
            // Over TCP, a lost packet delays the exchange. This is simulated by a missing exchange: the next one starts this interval later.
            _next += LostInterval;
            var there = _up.TrySend(settings, out var up, out var upJitter);
            var back = _down.TrySend(settings, out var down, out var downJitter);
            if (!there || !back) return;
            var arrived = t1 + up + upJitter;
            var sent = arrived + Turnaround;
            _underway = new SyncExchange(t1, _clock.At(arrived), _clock.At(sent), sent + down + downJitter);
        }
    }
}
