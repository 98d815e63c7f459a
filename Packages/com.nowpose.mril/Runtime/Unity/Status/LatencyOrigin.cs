using System.Collections.Generic;
using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Unity.Messages;

namespace Nowpose.Unity.Status
{
    /// <summary>
    /// Describes the origin of L_visu: the runtime, the settings, or a measurement with its method and date. If a condition differs from that of the
    /// measurement, names this condition instead.
    /// </summary>
    /// <remarks>Allocates only when the profile or its mismatches have changed.</remarks>
    sealed class LatencyOrigin
    {
        LatencyProfile _profile;
        IReadOnlyList<ConditionMismatch> _mismatches;
        string _measured;

        public string Of(SessionStatistics statistics)
        {
            if (statistics.IsDisplayTimeImplausible) return StatusMessages.LatencyImplausible;
            if (statistics.IsDisplayTimeInconsistent)
                return statistics.Profile != null ? StatusMessages.LatenciesDiffer : StatusMessages.LatencyNotVerified;
            if (statistics.IsLightPredicted) return StatusMessages.LatencyPredicted;
            if (statistics.Profile == null) return StatusMessages.LatencySet;
            if (statistics.Profile != _profile || statistics.ProfileMismatches != _mismatches)
            {
                _profile = statistics.Profile;
                _mismatches = statistics.ProfileMismatches;
                _measured = _mismatches.Count > 0 ? "other " + _mismatches[0].Label : LatencyProfileMessages.OriginOf(_profile);
            }
            return _measured;
        }
    }
}
