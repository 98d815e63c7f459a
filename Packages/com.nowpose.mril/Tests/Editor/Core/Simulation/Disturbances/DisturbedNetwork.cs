using System;
using System.Collections.Generic;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Sync;

namespace Nowpose.Tests.Core.Simulation.Disturbances
{
    /// <summary>The connections of a session with a disturbed cell: messages in the order in which they were sent, and sync exchanges.</summary>
    sealed class DisturbedNetwork
    {
        /// <summary>Time from a sample until it is sent, s: subscription and middleware.</summary>
        const double MinDelay = 0.055, DelayRange = 0.05;

        readonly CompensationSession _session;
        readonly DisturbedClock _clock;
        readonly List<Disturbance> _disturbances;
        readonly Random _random;
        readonly PathDelay _samples, _up, _down;
        readonly ExchangePace _pace;
        readonly Queue<(double Arrival, Action<HeadsetTime> Deliver)> _sent = new Queue<(double, Action<HeadsetTime>)>();
        (Action<HeadsetTime> Message, double Sent)? _heldBack;
        SyncExchange? _exchange;
        double _begun, _replied, _next, _inOrder, _asleepUntil;
        bool _isConnected;

        public DisturbedNetwork(CompensationSession session, DisturbedClock clock, List<Disturbance> disturbances, Random random)
        {
            (_session, _clock, _disturbances, _random) = (session, clock, disturbances, random);
            var wifi = NetworkProfile.Wifi;
            (_samples, _up, _down) = (wifi.Down(random.Next()), wifi.Up(random.Next()), wifi.Down(random.Next()));
            _pace = session.Settings.NewExchangePace(new Random(random.Next()));
        }

        /// <summary>Raised with the time of a new connection.</summary>
        public event Action<double> Connected;

        public bool IsAsleep(double now) => now < _asleepUntil;

        /// <summary>Sends a sample, which the action delivers at the time of its arrival.</summary>
        public void Send(double time, Action<HeadsetTime> message)
        {
            var sent = time + MinDelay + DelayRange * _random.NextDouble() + (_disturbances.Active(DisturbanceKind.Delay, time)?.Size ?? 0);
            if (_disturbances.Has(DisturbanceKind.SwappedPairs, time) && _heldBack == null)
            {
                _heldBack = (message, sent);
                return;
            }
            Enqueue(sent, message);
            if (_disturbances.Has(DisturbanceKind.Duplicates, time)) Enqueue(sent, message);
            if (_heldBack is var (former, before)) Enqueue(before, former);
            _heldBack = null;
        }

        /// <summary>Delivers everything that has arrived.</summary>
        public void Run(double now)
        {
            Connect(isConnected: !_disturbances.Has(DisturbanceKind.LostConnection, now), now);
            while (_sent.Count > 0 && _sent.Peek().Arrival <= now)
            {
                var (arrival, deliver) = _sent.Dequeue();
                deliver(_clock.HeadsetAt(arrival));
            }
            while (_exchange.HasValue ? _replied <= now : _next <= now)
            {
                if (_exchange.HasValue) EndExchange();
                else BeginExchange();
            }
            // Only exchanges show a step of the clock.
            if (!_isConnected || Released(now) > now) _clock.Postpone(now);
        }

        void Enqueue(double sent, Action<HeadsetTime> message)
        {
            if (_disturbances.Has(DisturbanceKind.LostConnection, sent)) return;
            _inOrder = Math.Max(_inOrder, Released(sent + _samples.Next().TotalSeconds));
            _sent.Enqueue((_inOrder, message));
        }

        // Time at which the headset can read what arrives at a given time.
        double Released(double time)
        {
            var later = Math.Max(_asleepUntil, _disturbances.Active(DisturbanceKind.Stall, time)?.End ?? time);
            return later > time ? Released(later) : time;
        }

        void Connect(bool isConnected, double now)
        {
            if (isConnected && !_isConnected) Connected?.Invoke(now);
            _isConnected = isConnected;
        }

        void EndExchange()
        {
            _session.Clock.Add(_exchange.Value, out _);
            _next = Math.Max(_replied, _begun + _pace.Next(_session.Clock, _exchange.Value.T4).TotalSeconds);
            _exchange = null;
        }

        // The headset falls asleep while it waits for a reply, which it reads when it wakes.
        void BeginExchange()
        {
            _begun = _next;
            _next += ProtocolLimits.SyncIntervalMs / 1000.0;
            if (!_isConnected) return;
            if (_disturbances.Active(DisturbanceKind.Sleep, _begun) is { } sleep) _asleepUntil = sleep.End;
            var arrived = _begun + _up.Next().TotalSeconds;
            if (_disturbances.Active(DisturbanceKind.Stall, arrived) is { } stall) arrived = stall.End;
            _replied = Released(arrived + _down.Next().TotalSeconds);
            _exchange = new SyncExchange(
                _clock.HeadsetAt(_begun), _clock.ControlAt(arrived), _clock.ControlAt(arrived), _clock.HeadsetAt(_replied),
                serverSynchronised: !_disturbances.Has(DisturbanceKind.UnsynchronisedServer, arrived));
        }
    }
}
