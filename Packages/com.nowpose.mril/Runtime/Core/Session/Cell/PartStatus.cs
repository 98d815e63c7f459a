using System;
using Nowpose.Messages;

namespace Nowpose.Session.Cell
{
    /// <summary>An object or a signal that the session shows and that is not current.</summary>
    readonly struct PartStatus
    {
        public PartStatus(string name, PoseState state, ControlTime? since, TimeSpan? age, string reason) =>
            (Name, State, Since, Age, Reason) = (name, state, since, age, reason);

        /// <summary>Name of the frame or of the signal.</summary>
        public string Name { get; }

        /// <summary><see cref="PoseState.Incomplete"/> until a pose or value can be shown; otherwise <see cref="PoseState.Held"/>.</summary>
        public PoseState State { get; }

        /// <summary>Time since which the part has not been current; null while unknown.</summary>
        public ControlTime? Since { get; }

        /// <summary>Time since <see cref="Since"/>, not negative; null while unknown.</summary>
        public TimeSpan? Age { get; }

        /// <summary>Reason in one line.</summary>
        public string Reason { get; }

        /// <summary>State, age and reason in one line, such as "not current for 4 s: no new poses are arriving"; allocates.</summary>
        public string Description => StateNames.Describe(StateNames.NotCurrent, Age, Reason);

        /// <summary>Compares by severity: parts without a pose or value first, then those that failed last.</summary>
        public static int Compare(PartStatus a, PartStatus b)
        {
            if (a.State != b.State) return a.State.CompareTo(b.State);
            var bySince = Nullable.Compare(b.Since, a.Since);
            return bySince != 0 ? bySince : string.CompareOrdinal(a.Name, b.Name);
        }
    }
}
