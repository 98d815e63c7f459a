using System.Collections.Generic;
using System.IO;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Unity.Rendering;
using UnityEngine;

namespace Nowpose.Unity.Calibration
{
    /// <summary>Looks for a latency profile where one may be, best first: saved on the device, shipped as a file, shipped as an asset.</summary>
    sealed class ProfilePlaces
    {
        readonly string _fileName;
        readonly TextAsset _asset;
        readonly List<string> _refusals = new List<string>();

        public ProfilePlaces(string fileName, TextAsset asset)
        {
            _fileName = fileName;
            _asset = asset;
        }

        /// <summary>Where <see cref="LatencyProfileLoader.Save"/> puts it.</summary>
        public string SavedPath => Path.Combine(Application.persistentDataPath, _fileName);

        /// <summary>Why places before the one that was found, or all, could not be used; one line each.</summary>
        public IReadOnlyList<string> Refusals => _refusals;

        /// <returns>Null where there is none that can be used on this device.</returns>
        public LatencyProfile Find(out string from)
        {
            _refusals.Clear();
            return Read(from = SavedPath) ?? Shipped(out from) ?? OfAsset(out from);
        }

        LatencyProfile Shipped(out string path)
        {
            path = Path.Combine(Application.streamingAssetsPath, _fileName);
            if (!path.Contains("://")) return Read(path);
            // Whoever has another place to look in need not be told.
            if (_asset == null && _refusals.Count == 0 && !File.Exists(SavedPath))
                _refusals.Add("latency profile: StreamingAssets is inside the app's archive here, where no file can be opened; assign the profile "
                    + "as a text asset, or copy it to " + SavedPath);
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
