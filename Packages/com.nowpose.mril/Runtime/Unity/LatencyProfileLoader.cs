using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Session;
using Nowpose.Unity.Calibration;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Loads the latency profile of this device into a session, and saves new profiles on the device.</summary>
    /// <remarks>
    /// Searches below the persistent data path, then in StreamingAssets, then its asset. A profile that is damaged, of a newer
    /// version, of another device or of another display rate is rejected with a message of one line, and the next place is searched. The
    /// profile in use stays.
    /// </remarks>
    [AddComponentMenu("Nowpose/Latency Profile Loader")]
    [DisallowMultipleComponent]
    public sealed class LatencyProfileLoader : MonoBehaviour
    {
        [SerializeField, Tooltip("The session to calibrate. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Name of the profile's file below the application's persistent data path, where it is also saved, and in "
            + "StreamingAssets; or a full path.")]
        string _fileName = "latency-profile.json";

        [SerializeField, Tooltip("Profile that is used if neither folder contains one. An Android app can get a profile only in this way. Empty: "
            + "none.")]
        TextAsset _shipped = null;

        const string Unkept = LoaderMessages.Unkept;

        MrilSession _source;
        CompensationSession _calibrated;
        DisplayConditions _judged;

        /// <summary>The profile in use; null while the session uses the value of its settings.</summary>
        public LatencyProfile Profile { get; private set; }

        /// <summary>The file or asset of <see cref="Profile"/>, or a note that it is not saved; null before the first.</summary>
        public string From { get; private set; }

        /// <summary>Why a profile was rejected or could not be saved, in one line; null unless there is a problem.</summary>
        public string Problem { get; private set; }

        /// <summary>Searches again, for a profile that was added since. Keeps the profile in use if none is valid.</summary>
        public void Reload()
        {
            var places = Places;
            var profile = places.Find(out var from);
            Problem = null;
            foreach (var refusal in places.Refusals) Fail(refusal);
            if (profile != null) Use(profile, from);
        }

        /// <summary>Saves a profile on the device, and uses it from the next frame on, even if it cannot be saved.</summary>
        /// <returns>Whether it was saved; otherwise <see cref="Problem"/> gives the reason. A profile of another device is not used.</returns>
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
            _source = this.RequiredSession(_session, "latency profile loader");
            _calibrated = null;
            _judged = null;
            Reload();
        }

        // Before the session computes its frame. A restarted session has the L_visu of its settings.
        void Update()
        {
            if (_source == null) return;
            Judge(_source.Session?.Conditions);
            if (Profile == null || _source.Session == _calibrated) return;
            _calibrated = _source.Session;
            _calibrated?.Calibrate(Profile);
        }

        // A display that starts late may report another rate than the profile's. Other mismatches are only warnings of the session.
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
            ConsoleLog.Info(this, "latency profile: " + CalibrationMessages.Of(profile) + "; from " + from);
        }

        void Fail(string problem)
        {
            Problem ??= problem;
            ConsoleLog.Warn(this, problem);
        }
    }
}
