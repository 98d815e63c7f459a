using System;
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
    /// Searches the persistent data path, then StreamingAssets, then the assigned text asset. Rejects a profile that is damaged, that has a newer
    /// version, or that belongs to another device or display rate; it then logs one line and searches the next place. If no place has a valid
    /// profile, the session keeps the profile in use.
    /// </remarks>
    [AddComponentMenu("Nowpose/Latency Profile Loader")]
    // Calibrates a session in the frame in which another component, such as Cell Pairing, has restarted it.
    [DefaultExecutionOrder(1)]
    [DisallowMultipleComponent]
    public sealed class LatencyProfileLoader : MonoBehaviour
    {
        [SerializeField, Tooltip("The session to calibrate. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("File name of the profile. The file is searched for below the application's persistent data path, where it is also "
            + "saved, and then in StreamingAssets. A full path is also allowed.")]
        string _fileName = "latency-profile.json";

        [SerializeField, Tooltip("Profile that is used if neither folder contains one. It is the only way to ship a profile with an Android app. "
            + "Empty: none.")]
        TextAsset _shipped = null;

        MrilSession _source;
        CompensationSession _calibrated;
        DisplayConditions _judged;

        /// <summary>The profile in use; null while the session uses L_visu from its settings.</summary>
        public LatencyProfile Profile { get; private set; }

        /// <summary>
        /// The file or asset from which <see cref="Profile"/> was loaded, or a note that the profile is not saved; null before the first profile.
        /// </summary>
        [field: NonSerialized] public string From { get; private set; }

        /// <summary>Reason why a profile was rejected or could not be saved, in one line; null if no problem is known.</summary>
        [field: NonSerialized] public string Problem { get; private set; }

        /// <summary>
        /// Searches for a profile again, for example after a file was copied to the device. Keeps the profile in use if none is valid.
        /// </summary>
        public void Reload()
        {
            var places = Places;
            var profile = places.Find(out var from);
            Problem = null;
            foreach (var refusal in places.Refusals) Fail(refusal);
            if (profile != null) Use(profile, from);
        }

        /// <summary>Saves a profile on the device, and uses it from the next frame on. A profile of another device is rejected.</summary>
        /// <returns>
        /// True if the profile was saved; otherwise <see cref="Problem"/> gives the reason. The profile is used even if it could not be saved.
        /// </returns>
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

        // Runs before the session computes its frame. A restarted session has L_visu from its settings and must be calibrated again.
        void Update()
        {
            if (_source == null) return;
            Judge(_source.Session?.Conditions);
            if (Profile == null || _source.Session == _calibrated) return;
            _calibrated = _source.Session;
            _calibrated?.Calibrate(Profile);
        }

        // Checks the profile again when the display reports its rate, which may be after the profile was loaded. If the rate differs, the profile is
        // invalid. The session itself warns about other mismatches.
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
                from = LoaderMessages.Unkept;
            }
            Use(profile, from);
        }

        void Use(LatencyProfile profile, string from)
        {
            Profile = profile;
            From = from;
            _calibrated = null;
            ConsoleLog.Info(this, LatencyProfileMessages.Loaded(profile, from));
        }

        void Fail(string problem)
        {
            Problem ??= problem;
            ConsoleLog.Warn(this, problem);
        }
    }
}
