using System;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>A rosbridge server's response to a call of the service get_time of rosapi.</summary>
    sealed class RosTimeAnswer
    {
        const int MaxReasonLength = 200;

        public RosTimeAnswer(RosbridgeMessage response, DropReason fault, HeadsetTime arrival)
        {
            Time = fault == DropReason.None ? response.Time : null;
            Arrival = arrival;
            Problem = Time == null ? ProblemOf(response, fault) : null;
            IsServiceMissing = Time == null && response.Text != null && response.Text.Contains("does not exist", StringComparison.Ordinal);
        }

        /// <summary>The server's time; null if the response contains none.</summary>
        public ControlTime? Time { get; }

        /// <summary>Time at which the last byte of the response was read.</summary>
        public HeadsetTime Arrival { get; }

        /// <summary>Reason why the time is unknown, and the remedy; null if it is known.</summary>
        public string Problem { get; }

        /// <summary>Whether the server has no service of this name.</summary>
        public bool IsServiceMissing { get; }

        static string ProblemOf(RosbridgeMessage response, DropReason fault)
        {
            if (fault == DropReason.StampZero) return ConnectionMessages.RosTimeZero;
            if (response.Result) return ConnectionMessages.RosTimeMissing(fault);
            var reason = InputException.OneLine(response.Text ?? "the call failed", MaxReasonLength);
            return ConnectionMessages.RosCallFailed(reason);
        }
    }
}
