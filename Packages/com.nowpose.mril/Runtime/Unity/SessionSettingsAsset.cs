using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Asset in which the user edits <see cref="SessionSettings"/>. Code never writes to it.</summary>
    [CreateAssetMenu(menuName = "Nowpose/Session Settings", fileName = "Session Settings")]
    public sealed class SessionSettingsAsset : ScriptableObject
    {
        [Header("Gateway")]
        [SerializeField, Tooltip("Name or address of the gateway. 127.0.0.1 is this machine: use it for a gateway on the same machine as "
            + "the editor.")]
        string _host = "127.0.0.1";

        [SerializeField, Tooltip("TCP port of the clock synchronisation, 1 to 65535. The gateway's default is 47010.")]
        int _syncPort = ProtocolLimits.SyncPort;

        [SerializeField, Tooltip("TCP port of the joint positions, 1 to 65535. The gateway's default is 47011.")]
        int _webSocketPort = ProtocolLimits.WebSocketPort;

        [SerializeField, Tooltip("The gateway's public key as the gateway prints it, sha256/…=. With a pin, both connections are encrypted and "
            + "accept this key only. Empty: no pin.")]
        string _pin = "";

        [SerializeField, Tooltip("Encrypt the connections and accept a certificate that the device's certificate store trusts. Not needed with a "
            + "pin.")]
        bool _deviceTrust = false;

        [SerializeField, Tooltip("Token that identifies this headset to the gateway, up to 512 bytes. It is sent only encrypted or within this "
            + "machine. The project and the app contain it as readable text; pass it to ToSettings instead to avoid this. Empty: no token.")]
        string _token = "";

        [SerializeField, Tooltip("Allow unencrypted connections to another machine. Use it only on a network in which every device is trusted. "
            + "The status panel shows that it is on.")]
        bool _insecureLan = false;

        [SerializeField, Tooltip("Name of this headset in its diagnostics, 1 to 128 characters; must be unique at the gateway. Empty: the "
            + "device's name in its system settings; on Android with four hexadecimal digits.")]
        string _headsetName = "";

        [SerializeField, Tooltip("Namespace of the session's robot in the cell, such as arm1 for /arm1/joint_states. Empty: the robot without a "
            + "namespace.")]
        string _robotNamespace = "";

        [SerializeField, Tooltip("Send the displayed joints to the gateway up to 20 times a second, about 9 kB/s, so that its operations page "
            + "can draw them beside the robot. Frames do not wait for it.")]
        bool _publishDisplayed = true;

        [Header("Display")]
        [SerializeField, Tooltip("L_visu in ms, 0 to 500: from the start of a frame until its light reaches the eye. Calibrate it for your "
            + "device; 40 ms is about two and a half frames at 60 Hz.")]
        double _visualisationMs = 40;

        [SerializeField, Tooltip("Maximum render time in ms, 0.1 to 1000, at which L_visu is constant. Beyond it the pose is marked. 0: not "
            + "calibrated, so only frames that miss refreshes of the display are marked.")]
        double _renderTimeLimitMs = 0;

        [SerializeField, Tooltip("Source of the render times from which the limit was determined. The limit is not valid for another source.")]
        RenderTimeSourceKind _renderTimeLimitSource = RenderTimeSourceKind.None;

        [SerializeField, Tooltip("Response while the render time is outside the constant-latency range, or frames miss refreshes of the display. "
            + "Fade: the predicted pose, fainter. Go On: the predicted pose, only slightly fainter. Hold: the newest samples. Stripes and a label "
            + "mark the robot in each case. Default Fade, because a late prediction is more accurate than the newest samples.")]
        OutsideRangeResponse _outsideRange = OutsideRangeResponse.Fade;

        [SerializeField, Tooltip("Compute the pose again right before rendering, after Unity has waited for the display. Leave it on for headsets: "
            + "without it, L_visu includes this wait and varies with the processor time of your scripts. It doubles the computation. Calibrate "
            + "L_visu with the same setting.")]
        bool _rewriteBeforeRender = true;

        [Header("Prediction")]
        [SerializeField, PredictorName, Tooltip("adaptive, hold, linear, quadratic, cubic, quadratic-h3, quadratic-h4 or gp. adaptive selects "
            + "the best forecast from the motion and tolerates inaccurate time stamps; quadratic is the paper's method.")]
        string _predictor = Predictors.Default;

        [SerializeField, Tooltip("Maximum time in ms by which a prediction is ahead of the newest sample, 0 to 5000. Beyond it the pose stays "
            + "and is marked as held. Default 300: the error of a prediction grows with its horizon.")]
        double _horizonCapMs = 300;

        [SerializeField, Tooltip("Maximum time between two samples, ms, 1 to 60000. After a longer gap the prediction starts again, because the "
            + "motion before the gap does not determine the motion after it.")]
        double _maximumGapMs = 500;

        [SerializeField, Tooltip("Time constant in ms with which a joint moves to the corrected prediction after a new sample, 0 to 200. It is at "
            + "most a fifth of the sampling interval. 0: the joint jumps. Default 14: the error increases by less than 5 %.")]
        double _blendMs = PredictionSettings.DefaultBlendMs;

        [SerializeField, Tooltip("Display joints at the set-points that the control system publishes ahead of time, delayed by the lag of the "
            + "joints. Joints that do not follow their set-points are predicted.")]
        bool _followPlan = true;

        [SerializeField, Tooltip("Maximum speed of the robot's programs in percent of the URDF's velocity limits, 1 to 100. The predictor adaptive "
            + "predicts no higher speed, unless the joint already moves faster. Example: with a speed override of 30 percent, enter 30.")]
        double _speedPercent = 100;

        [SerializeField, Tooltip("Maximum acceleration of revolute joints for which the URDF states none, radians per second squared, 0.01 to "
            + "1000000. 0: unknown. If this limit and the jerk limit are known, moves from rest to rest are predicted with their motion profile.")]
        double _accelerationRadians = 0;

        [SerializeField, Tooltip("Maximum jerk of revolute joints for which the URDF states none, radians per second cubed, 0.01 to 1000000. 0: "
            + "unknown. The value is in the robot's data sheet or in the machine data of its control system.")]
        double _jerkRadians = 0;

        [Header("Clock")]
        [SerializeField, Tooltip("Source of the control time. Clock Sync: the gateway, on the Sync Port. Ros Time: the service /rosapi/get_time "
            + "of a rosbridge server without a gateway; the Sync Port is not used, and the time is less accurate.")]
        ControlClockSource _clockSource = ControlClockSource.ClockSync;

        [SerializeField, ClockEstimatorName, Tooltip("Method that estimates the clock offset, default or ransac. ransac is the paper's method; "
            + "default is 5 to 15 times more accurate over WiFi and follows clock steps.")]
        string _clockEstimator = ClockEstimators.Default;

        [SerializeField, Tooltip("Time between two clock exchanges, ms, 20 to 10000. The session uses a quarter of this time after it has "
            + "connected and after a clock step, and up to five times this time while the offset is very accurate. Default 200: the clock is "
            + "synchronised within seconds, at a low network load.")]
        double _syncIntervalMs = ProtocolLimits.SyncIntervalMs;

        internal string RobotNamespace => _robotNamespace ?? "";

        static double Known(double limit) => limit == 0 ? double.PositiveInfinity : limit;

        /// <summary>Checks the values, and returns them as settings.</summary>
        /// <param name="token">
        /// Token that replaces the token of this asset. If it is null, the asset's token is used; if it is empty, no token is used.
        /// </param>
        /// <exception cref="InputException">A value is invalid. The message names this asset, the value and the allowed values.</exception>
        public SessionSettings ToSettings(string token = null)
        {
            try
            {
                return new SessionSettings(
                    Connection(token ?? _token),
                    VisualisationLatency.FromMilliseconds(_visualisationMs),
                    new PredictionSettings(
                        _predictor, _horizonCapMs, _maximumGapMs, _blendMs, _followPlan, _speedPercent / 100, Known(_accelerationRadians),
                        Known(_jerkRadians)),
                    syncIntervalMs: _syncIntervalMs,
                    range: _renderTimeLimitMs == 0 ? null : new ConstantLatencyRange(_renderTimeLimitMs, _renderTimeLimitSource),
                    rewriteBeforeRender: _rewriteBeforeRender,
                    clockEstimator: _clockEstimator,
                    outsideRange: _outsideRange,
                    robotNamespace: _robotNamespace);
            }
            catch (InputException fault)
            {
                throw new InputException("'" + name + "': " + fault.Message, fault);
            }
        }

        ConnectionSettings Connection(string token) => new ConnectionSettings(
            _host, _syncPort, _webSocketPort,
            string.IsNullOrWhiteSpace(_pin) ? null : CertificatePin.Parse(_pin), _deviceTrust,
            string.IsNullOrEmpty(token) ? null : token, _insecureLan,
            string.IsNullOrEmpty(_headsetName) ? HeadsetName.Of(null) : _headsetName, _publishDisplayed, _clockSource);
    }
}
