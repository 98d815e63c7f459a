using System;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>State of a joint that is not live, as the gateway reports it or as the session detects it.</summary>
    public readonly struct JointStatus
    {
        public JointStatus(string joint, JointDataState state, ControlTime? since, TimeSpan? age, string reason) =>
            (Joint, State, Since, Age, Reason) = (joint, state, since, age, reason);

        /// <summary>The joint's name in the URDF.</summary>
        public string Joint { get; }

        public JointDataState State { get; }

        /// <summary>Start of <see cref="State"/>; null while unknown.</summary>
        public ControlTime? Since { get; }

        /// <summary>Time since <see cref="Since"/> at the snapshot, not negative; null while unknown.</summary>
        public TimeSpan? Age { get; }

        /// <summary>Reason in one line; empty while unknown.</summary>
        public string Reason { get; }

        /// <summary>Whether the joint has no data, so that it is not shown as current. False for a joint that is assumed to be at rest.</summary>
        public bool IsMissing => !State.IsGood();

        /// <summary>Whether the joint is assumed to be at rest, but the gateway reports that it may not be.</summary>
        internal bool IsRestUncertain => State == JointDataState.Rest && Reason?.StartsWith(StateNames.UncertainRestReason, StringComparison.Ordinal) == true;

        /// <summary>State, age and reason in one line, such as "no data for 4 s: node deleted"; allocates.</summary>
        public string Description => StateNames.Describe(Words, Age, Reason);

        /// <summary>Returns the description with a time in the caller's format, such as "no data since 14:03:12: node deleted"; allocates.</summary>
        /// <param name="since">The time as a string; null to omit it.</param>
        public string DescriptionSince(string since) => StateNames.Describe(Words, since == null ? "" : " since " + since, Reason);

        // Samples that are too old to be displayed are data.
        string Words => Reason == RobotMessages.SamplesTooOld ? StateNames.NotCurrent : WordsOf(State);

        static string WordsOf(JointDataState state)
        {
            switch (state)
            {
                case JointDataState.Live: return "live";
                case JointDataState.Rest: return "assumed at rest";
                case JointDataState.Refused: return StateNames.ValuesUnusable;
                case JointDataState.Missing: return "no value";
                default: return "no data";
            }
        }
    }
}
