using System.Globalization;
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
            if (statistics.IsDisplayTimeDoubted) return "runtime and calibration differ";
            if (statistics.IsLightPredicted) return "predicted by the runtime";
            if (statistics.Profile == null) return "as set";
            if (statistics.Profile != _profile)
            {
                _profile = statistics.Profile;
                _measured = MethodOf(_profile.Method) + ", " + _profile.MeasuredUtc.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture);
            }
            return _measured;
        }

        static string MethodOf(CalibrationMethod method)
        {
            switch (method)
            {
                case CalibrationMethod.VisibleLight: return "by visible light";
                case CalibrationMethod.Sine: return "by sine jog";
                case CalibrationMethod.Nudge: return "by eye";
                default: return "by hand";
            }
        }
    }
}
