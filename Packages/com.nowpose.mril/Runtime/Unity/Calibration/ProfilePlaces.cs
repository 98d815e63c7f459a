using System.Collections.Generic;
using System.IO;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using UnityEngine;

namespace Nowpose.Unity.Calibration
{
    /// <summary>
    /// Searches for a latency profile in this order: the file saved on the device, the file in StreamingAssets, the text asset in the build.
    /// </summary>
    sealed class ProfilePlaces
    {
        readonly string _fileName;
        readonly TextAsset _asset;
        readonly List<string> _refusals = new List<string>();

        public ProfilePlaces(string fileName, TextAsset asset) => (_fileName, _asset) = (fileName, asset);

        /// <summary>Path of the file that <see cref="LatencyProfileLoader.Save"/> writes.</summary>
        public string SavedPath => Path.Combine(Application.persistentDataPath, _fileName);

        /// <summary>
        /// Reasons, one line each, why the last search rejected profiles or could not search a place. If a profile was found, these are the reasons
        /// for the places that were searched before it.
        /// </summary>
        public IReadOnlyList<string> Refusals => _refusals;

        /// <summary>Searches for the first profile that is valid for this device.</summary>
        /// <param name="from">Path or name of the place where the profile was found, or of the last place that was searched.</param>
        /// <returns>Null if no profile is valid.</returns>
        public LatencyProfile Find(out string from)
        {
            _refusals.Clear();
            return Read(from = SavedPath) ?? Shipped(out from) ?? OfAsset(out from);
        }

        LatencyProfile Shipped(out string path)
        {
            path = Path.Combine(Application.streamingAssetsPath, _fileName);
            if (!path.Contains("://")) return Read(path);
            // Reports this place only if there is neither a saved file nor a text asset.
            if (_asset == null && _refusals.Count == 0 && !File.Exists(SavedPath))
                _refusals.Add(LoaderMessages.InArchive(SavedPath));
            return null;
        }

        LatencyProfile OfAsset(out string name)
        {
            name = _asset == null ? null : "text asset '" + _asset.name + "'";
            return _asset == null ? null : Checked(name, () => LatencyProfileJson.Read(_asset.text, "'" + _asset.name + "'"));
        }

        LatencyProfile Read(string path) => File.Exists(path) ? Checked(path, () => LatencyProfileFile.Load(path)) : null;

        LatencyProfile Checked(string name, System.Func<LatencyProfile> read)
        {
            try
            {
                var profile = read();
                var refusal = profile.RefusalFor(ThisDevice.Conditions);
                if (refusal == null) return profile;
                _refusals.Add(name + ": " + refusal);
            }
            catch (InputException fault)
            {
                _refusals.Add(fault.Message);
            }
            return null;
        }
    }
}
