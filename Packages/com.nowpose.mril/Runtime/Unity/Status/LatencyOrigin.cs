using Nowpose.Latency;
using Nowpose.Session;

namespace Nowpose.Unity
{
    /// <summary>Says where L_visu comes from: how and when it was measured, who predicts it, or that it was set as a number.</summary>
    /// <remarks>Allocates only when the profile is another one.</remarks>
    sealed class LatencyOrigin
    {
        LatencyProfile _profile;
        string _measured;

        public string Of(SessionStatistics statistics)
        {
            if (statistics.IsDisplayTimeImplausible) return "runtime's are implausible";
            if (statistics.IsDisplayTimeDoubted) return "runtime and calibration differ";
            if (statistics.IsLightPredicted) return "predicted by the runtime";
            if (statistics.Profile == null) return "as set";
            if (statistics.Profile != _profile)
            {
                _profile = statistics.Profile;
                _measured = CalibrationWords.OriginOf(_profile);
            }
            return _measured;
        }
    }
}
