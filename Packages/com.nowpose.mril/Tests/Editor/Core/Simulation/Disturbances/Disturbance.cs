using System;
using System.Collections.Generic;

namespace Nowpose.Tests.Core.Simulation.Disturbances
{
    enum DisturbanceKind
    {
        /// <summary>Everything arrives late and at once, as over TCP after an interruption of the radio.</summary>
        Stall,

        /// <summary>The connection is lost with all that was sent, and a new one begins.</summary>
        LostConnection,

        /// <summary>The headset computes no frames and reads no messages; replies to its requests wait in the socket.</summary>
        Sleep,

        /// <summary>The source of the joints sends nothing, or its newest message again and again.</summary>
        SilentJoints,

        /// <inheritdoc cref="SilentJoints"/>
        RepeatedJoints,

        /// <summary>Messages contain only some of the joints.</summary>
        SomeJoints,

        /// <summary>The source of the objects sends nothing, or puts them on an unknown parent.</summary>
        SilentObjects,

        /// <inheritdoc cref="SilentObjects"/>
        UnknownParent,

        /// <summary>Each message arrives twice, or pairs of messages in the opposite order.</summary>
        Duplicates,

        /// <inheritdoc cref="Duplicates"/>
        SwappedPairs,

        /// <summary>Sampling interval of <see cref="Disturbance.Size"/> s.</summary>
        OtherInterval,

        /// <summary>Additional delay of all samples, in s.</summary>
        Delay,

        /// <summary>Frames with an interval of <see cref="Disturbance.Size"/> s.</summary>
        SlowFrames,

        /// <summary>The control clock steps by <see cref="Disturbance.Size"/> s.</summary>
        ClockStep,

        /// <summary>The rate of the control clock changes.</summary>
        ClockRate,

        /// <summary>The server states that its clock is not synchronised.</summary>
        UnsynchronisedServer,
    }

    /// <summary>One disturbance of a simulated cell, with random time, duration and size.</summary>
    sealed class Disturbance
    {
        static readonly double[] Intervals = { 0.01, 0.02, 0.1, 0.2 };

        readonly DisturbanceKind _kind;

        Disturbance(DisturbanceKind kind, double start, double seconds, double size) =>
            (_kind, Start, End, Size) = (kind, start, start + seconds, size);

        /// <summary>Start in s; the disturbance ends before <see cref="End"/>.</summary>
        public double Start { get; }

        public double End { get; }

        public double Size { get; }

        public bool Is(DisturbanceKind kind) => _kind == kind;

        public bool IsActive(DisturbanceKind kind, double time) => _kind == kind && time >= Start && time < End;

        public static List<Disturbance> Some(Random random)
        {
            var some = new List<Disturbance>();
            const int kinds = (int)DisturbanceKind.UnsynchronisedServer + 1;
            for (var count = random.Next(1, 6); count > 0; count--)
                some.Add(One((DisturbanceKind)random.Next(kinds), 12 + 20 * random.NextDouble(), random));
            return some;
        }

        public override string ToString() => FormattableString.Invariant($"{_kind} {Start:0.0} to {End:0.0} s, {Size:g3}");

        static Disturbance One(DisturbanceKind kind, double start, Random random)
        {
            var sign = 2 * random.Next(2) - 1;
            switch (kind)
            {
                case DisturbanceKind.Sleep: return new Disturbance(kind, start, Between(random, 0.3, 300), 0);
                case DisturbanceKind.ClockStep: return new Disturbance(kind, start, 0, sign * Between(random, 0.005, 20));
                case DisturbanceKind.ClockRate: return new Disturbance(kind, start, 0, sign * Between(random, 5e-6, 100e-6));
                case DisturbanceKind.OtherInterval:
                    return new Disturbance(kind, start, Between(random, 1, 10), Intervals[random.Next(Intervals.Length)]);
                case DisturbanceKind.Delay: return new Disturbance(kind, start, Between(random, 1, 10), Between(random, 0.02, 0.3));
                case DisturbanceKind.SlowFrames: return new Disturbance(kind, start, Between(random, 1, 10), Between(random, 0.03, 0.4));
                default: return new Disturbance(kind, start, Between(random, 0.1, 8), 0);
            }
        }

        static double Between(Random random, double min, double max) => min * Math.Pow(max / min, random.NextDouble());
    }

    static class DisturbanceLists
    {
        /// <summary>Returns a disturbance that is active at a given time; null if there is none.</summary>
        public static Disturbance Active(this List<Disturbance> disturbances, DisturbanceKind kind, double time) =>
            disturbances.Find(one => one.IsActive(kind, time));

        public static bool Has(this List<Disturbance> disturbances, DisturbanceKind kind, double time) => disturbances.Active(kind, time) != null;
    }
}
