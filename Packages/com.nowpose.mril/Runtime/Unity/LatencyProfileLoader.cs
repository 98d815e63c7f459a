using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Session;
using Nowpose.Unity.Calibration;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Gives a session what the calibration of this device found, and keeps what is found on the device.</summary>
    /// <remarks>
    /// Looks below the persistent data path, then in StreamingAssets, then at its asset. A profile that is torn, of a newer
    /// version, of another device or of another display rate is refused in one line and the next place is looked at; what was
    /// in use stays.
    /// </remarks>
    [AddComponentMenu("Nowpose/Latency Profile Loader")]
    [DisallowMultipleComponent]
    public sealed class LatencyProfileLoader : MonoBehaviour
    {
        [SerializeField, Tooltip("The session that is calibrated. Empty: the one on this object or above.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Name of the profile's file below the application's persistent data path, where it is also saved, and in "
            + "StreamingAssets; or a full path.")]
        string _fileName = "latency-profile.json";

        [SerializeField, Tooltip("The profile where neither folder has one: the only way to ship it with an Android app. Empty: none.")]
        TextAsset _shipped = null;

        const string Unkept = "a calibration that is not kept";

        MrilSession _source;
        CompensationSession _calibrated;
        DisplayConditions _judged;

        /// <summary>What is in use; null while the session has what its settings say.</summary>
        public LatencyProfile Profile { get; private set; }

        /// <summary>The file or asset that <see cref="Profile"/> came from, or that it is not kept, in a few words; null before the first.</summary>
        public string From { get; private set; }

        /// <summary>Why a profile was refused or could not be saved, in one line; null when nothing is wrong.</summary>
        public string Problem { get; private set; }

        /// <summary>Looks for a profile anew: somebody may have put one there. What is in use stays where none can be used.</summary>
        public void Reload()
        {
            var places = Places;
            var profile = places.Find(out var from);
            Problem = null;
            foreach (var refusal in places.Refusals) Fail(refusal);
            if (profile != null) Use(profile, from);
        }

        /// <summary>Keeps a profile on the device, and uses it from the next frame on, also where it cannot be kept.</summary>
        /// <returns>Whether it is kept; <see cref="Problem"/> says why not. One of another device is not even used.</returns>
        public bool Save(LatencyProfile profile)
        {
            Problem = profile.RefusalFor(ThisDevice.Conditions);
            if (Problem == null) Keep(profile);
            if (Problem != null) ConsoleLog.Warn(this, Problem);
            return Problem == null;
        }

        ProfilePlaces Places => new ProfilePlaces(_fileName, _shipped);

        void OnEnable()
        {
            _source = this.SessionOr(_session);
            if (_source == null) ConsoleLog.Warn(this, "latency profile loader '" + name + "' has no session above it to calibrate; assign one");
            _calibrated = null;
            _judged = null;
            Reload();
        }

        // Before the session computes its frame. A session that begins anew has its settings' L_visu.
        void Update()
        {
            if (_source == null) return;
            Judge(_source.Session?.Conditions);
            if (Profile == null || _source.Session == _calibrated) return;
            _calibrated = _source.Session;
            _calibrated?.Calibrate(Profile);
        }

        // A display that starts late reports another rate than the profile's. Other mismatches are warnings, which the session gives.
        void Judge(DisplayConditions conditions)
        {
            if (conditions == null || ReferenceEquals(conditions, _judged)) return;
            _judged = conditions;
            if (Profile?.RefusalFor(conditions) == null) return;
            Profile = null;
            _calibrated?.Calibrate(null);
            Reload();
        }

        void Keep(LatencyProfile profile)
        {
            var from = Places.SavedPath;
            try
            {
                LatencyProfileFile.Save(from, profile);
            }
            catch (InputException fault)
            {
                Problem = fault.Message;
                from = Unkept;
            }
            Use(profile, from);
        }

        void Use(LatencyProfile profile, string from)
        {
            Profile = profile;
            From = from;
            _calibrated = null;
            ConsoleLog.Say(this, "latency profile: " + CalibrationWords.Of(profile) + "; from " + from);
        }

        void Fail(string problem)
        {
            Problem ??= problem;
            ConsoleLog.Warn(this, problem);
        }
    }
}
