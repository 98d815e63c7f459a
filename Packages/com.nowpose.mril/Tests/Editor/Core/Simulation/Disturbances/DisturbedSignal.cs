using System;
using System.Collections.Generic;
using Nowpose.Protocol.Cell;
using Nowpose.Session;

namespace Nowpose.Tests.Core.Simulation.Disturbances
{
    /// <summary>A signal of a disturbed cell that counts its changes, which the cell sends once each and again after a reconnection.</summary>
    sealed class DisturbedSignal
    {
        /// <summary>Name of the signal.</summary>
        public const string Name = "count";

        /// <summary>Range of the time between two changes, s.</summary>
        const double MinInterval = 0.1, MaxInterval = 4;

        readonly Random _random;
        readonly DisturbedClock _clock;
        readonly List<(double Time, ControlTime Stamp)> _changes = new List<(double, ControlTime)>();
        int _delivered = -1;

        public DisturbedSignal(int seed, DisturbedClock clock) => (_random, _clock) = (new Random(seed), clock);

        /// <summary>Time of the next change, s.</summary>
        public double Next { get; private set; }

        /// <summary>Changes the signal at <see cref="Next"/>, and returns the delivery of the change to a session.</summary>
        public Action<HeadsetTime> Change(CompensationSession session)
        {
            _changes.Add((Next, _clock.ControlAt(Next)));
            Next += MinInterval + (MaxInterval - MinInterval) * _random.NextDouble();
            return Delivery(_changes.Count - 1, session);
        }

        /// <summary>Sends the newest value that the gateway has received.</summary>
        public void SendAgain(CompensationSession session, HeadsetTime at, double now)
        {
            var newest = _changes.FindLastIndex(change => change.Time < now - 0.1);
            if (newest >= 0) Delivery(newest, session)(at);
        }

        /// <summary>Returns whether a value may be visible: the newest delivered one, at the display time or up to two frames before or after.</summary>
        public bool MayBe(double value, double light)
        {
            foreach (var time in new[] { light - 0.03, light, light + 0.03 })
                if (value == Math.Min(_delivered, _changes.FindLastIndex(change => change.Time <= time))) return true;
            return false;
        }

        Action<HeadsetTime> Delivery(int change, CompensationSession session) => at =>
        {
            session.Listener.SignalsReceived(new SignalsMessage(_changes[change].Stamp, new SignalValue(Name, change)), at);
            _delivered = Math.Max(_delivered, change);
        };
    }
}
