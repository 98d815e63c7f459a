using System.Collections.Generic;
using Nowpose.Latency;
using Nowpose.Session;

namespace Nowpose.Unity.Status
{
    /// <summary>Says where L_visu comes from: its measurement, the condition that has changed since, a prediction, or a number of the settings.</summary>
    /// <remarks>Allocates only when the profile is another one.</remarks>
    sealed class LatencyOrigin
    {
        LatencyProfile _profile;
        IReadOnlyList<ConditionMismatch> _mismatches;
        string _measured;

        public string Of(SessionStatistics statistics)
        {
            if (statistics.IsDisplayTimeImplausible) return "runtime's are implausible";
            if (statistics.IsDisplayTimeDoubted) return "runtime and calibration differ";
            if (statistics.IsLightPredicted) return "predicted by the runtime";
            if (statistics.Profile == null) return "as set";
            if (statistics.Profile != _profile || statistics.ProfileMismatches != _mismatches)
            {
                _profile = statistics.Profile;
                _mismatches = statistics.ProfileMismatches;
                _measured = _mismatches.Count > 0 ? "other " + _mismatches[0].Label : CalibrationWords.OriginOf(_profile);
            }
            return _measured;
        }
    }
}
