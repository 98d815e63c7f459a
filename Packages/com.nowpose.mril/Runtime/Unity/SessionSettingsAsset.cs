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
    /// <summary>User-editable asset with <see cref="SessionSettings"/>. Code never writes to it.</summary>
    [CreateAssetMenu(menuName = "Nowpose/Session Settings", fileName = "Session Settings")]
    public sealed class SessionSettingsAsset : ScriptableObject
    {
        [Header("Gateway")]
        [SerializeField, Tooltip("Name or address of the gateway. 127.0.0.1 is this machine: a gateway beside the editor.")]
        string _host = "127.0.0.1";

        [SerializeField, Tooltip("TCP port of the clock synchronisation, 1 to 65535. 47010 is what the gateway listens on by default.")]
        int _syncPort = ProtocolLimits.SyncPort;

        [SerializeField, Tooltip("Port of the joint positions, 1 to 65535. 47011 is what the gateway listens on by default.")]
        int _webSocketPort = ProtocolLimits.WebSocketPort;

        [SerializeField, Tooltip("The gateway's public key as the gateway prints it, sha256/…=. With it both connections are encrypted and trust "
            + "this key only. Empty: none.")]
        string _pin = "";

        [SerializeField, Tooltip("Encrypt, and trust a certificate that the device's own store trusts. Not needed beside a pin.")]
        bool _deviceTrust = false;

        [SerializeField, Tooltip("What proves this headset to a gateway that asks for it, up to 512 bytes; travels encrypted or within this "
            + "machine only. It lies readable in the project and in the app: better give it to ToSettings. Empty: none.")]
        string _token = "";

        [SerializeField, Tooltip("Allow unencrypted connections to another machine. Only in a network whose every member is trusted; the "
            + "status panel shows it.")]
        bool _insecureLan = false;

        [SerializeField, Tooltip("Names this headset in its diagnostics, 1 to 128 characters; no two at one gateway may share theirs. Empty: the name that "
            + "the device has in its system settings.")]
        string _headsetName = "";

        [SerializeField, Tooltip("Tell the gateway up to 20 times a second which joints are shown, about 9 kB/s, so that its page of operations can "
            + "draw them beside the robot. On: no frame does anything for it.")]
        bool _publishDisplayed = true;

        [Header("Display")]
        [SerializeField, Tooltip("L_visu in ms, 0 to 500: from the start of a frame until its light reaches the eye. Calibrate it for your "
            + "device; 40 ms is about two and a half frames at 60 Hz.")]
        double _visualisationMs = 40;

        [SerializeField, Tooltip("Render time in ms, 0.1 to 1000, up to which L_visu is constant; beyond it the pose is marked. 0: not "
            + "calibrated yet, so nothing is marked.")]
        double _renderTimeLimitMs = 0;

        [SerializeField, Tooltip("What the render time was measured with when its limit was found. The limit means nothing for another source.")]
        RenderTimeSourceKind _renderTimeLimitSource = RenderTimeSourceKind.None;

        [SerializeField, Tooltip("What is shown while the render time is outside the range: the pose goes on and fades, goes on as bright as ever, or "
            + "the newest samples are held. It is striped and said in words each time. Fade: it is late by an unknown time, yet better than held.")]
        OutsideRangeResponse _outsideRange = OutsideRangeResponse.Fade;

        [SerializeField, Tooltip("Compute and write the pose again right before rendering, with the newer time: a few ms less to predict for "
            + "twice the work. Off, for L_visu has to be calibrated with the same choice.")]
        bool _rewriteBeforeRender = false;

        [Header("Prediction")]
        [SerializeField, PredictorName, Tooltip("adaptive, hold, linear, quadratic, cubic, quadratic-h3, quadratic-h4 or gp. Adaptive learns from the motion which of "
            + "them is right, and bears samples' times that are off; quadratic is the paper's.")]
        string _predictor = Predictors.Default;

        [SerializeField, Tooltip("How far ahead of the newest sample is predicted at most, ms, 0 to 5000; then the pose stays and is marked as "
            + "held. 300 ms: beyond it a prediction is worse than none.")]
        double _horizonCapMs = 300;

        [SerializeField, Tooltip("A longer pause between two samples ends their history, ms, 1 to 60000. 500 ms: what the robot did before says "
            + "nothing about what it does after.")]
        double _maximumGapMs = 500;

        [SerializeField, Tooltip("Within how many ms a joint glides most of the way from one prediction to the next when a sample corrects it, "
            + "0 to 200; 0: it jumps. 14 ms costs less than 5 % of accuracy. Samples that come quickly shorten it.")]
        double _blendMs = PredictionSettings.DefaultBlendMs;

        [SerializeField, Tooltip("Show joints by the set-points that the control system publishes ahead of time, as late as the joints follow "
            + "them; nothing is predicted then. On: a joint that does not follow is predicted as ever.")]
        bool _followPlan = true;

        [SerializeField, Tooltip("What the robot's programs use of the velocity limits in its URDF, percent, 1 to 100. 100: the limits as they are; "
            + "no prediction moves faster. With the override at 30 percent, enter 30.")]
        double _speedPercent = 100;

        [SerializeField, Tooltip("Maximum acceleration of revolute joints whose URDF has none, radians per second squared, 0.01 to 1000000; 0: not "
            + "known. With both limits moves from rest to rest are predicted by their profile.")]
        double _accelerationRadians = 0;

        [SerializeField, Tooltip("Maximum jerk of revolute joints whose URDF has none, radians per second cubed, 0.01 to 1000000; 0: not known. The "
            + "value is in the robot's data sheet or its control's machine data.")]
        double _jerkRadians = 0;

        [Header("Clock")]
        [SerializeField, Tooltip("Whom to ask for the control time. Clock Sync: the gateway, on the Sync Port. Ros Time: a rosbridge server without a "
            + "gateway, by its service /rosapi/get_time; nothing uses the Sync Port then, and the time is less exact.")]
        ControlClockSource _clockSource = ControlClockSource.ClockSync;

        [SerializeField, ClockEstimatorName, Tooltip("default or ransac: how the offset of the headset's clock is found. ransac is the paper's; default is 5 to 15 "
            + "times closer over WiFi and follows clocks that step.")]
        string _clockEstimator = ClockEstimators.Default;

        [SerializeField, Tooltip("From one clock exchange to the next, ms, 20 to 10000; a quarter of it at the start and after a step, five times "
            + "as much on a quiet network. 200 ms: the clock is known within seconds, and the network hardly notices.")]
        double _syncIntervalMs = ProtocolLimits.SyncIntervalMs;

        static double Known(double limit) => limit == 0 ? double.PositiveInfinity : limit;

        /// <param name="token">Replaces this asset's token; null to use the asset's, empty for none.</param>
        /// <exception cref="InputException">A value is invalid; the message names this asset, the value and what is allowed.</exception>
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
                    outsideRange: _outsideRange);
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
