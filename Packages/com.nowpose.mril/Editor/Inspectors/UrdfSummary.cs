using System;
using System.Globalization;
using System.Linq;
using System.Text;
using Nowpose.Kinematics;
using Nowpose.Unity;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Summary of a robot description, as strings for an inspector.</summary>
    sealed class UrdfSummary
    {
        const int Lines = 12, LineLength = 120;

        readonly string _urdf;

        public UrdfSummary(RobotDescriptionAsset asset)
        {
            _urdf = asset.Urdf ?? "";
            Length = _urdf.Length.ToString(CultureInfo.InvariantCulture);
            Hash = _urdf.Length == 0 ? LiveText.Unknown : UrdfHash.Of(_urdf);
            Beginning = BeginningOf(_urdf);
            try
            {
                var model = asset.Read();
                Robot = model.Name;
                Joints = string.Join(", ", model.MovingJoints.Select(j => j.Name));
            }
            catch (InputException e)
            {
                Fault = e.Message;
            }
        }

        public string Robot { get; } = LiveText.Unknown;
        public string Joints { get; } = LiveText.Unknown;
        public string Length { get; }

        /// <summary>Hash of the URDF. A session compares it with the hash of the gateway's description.</summary>
        public string Hash { get; }

        /// <summary>First lines of the URDF. An ellipsis marks omitted text.</summary>
        public string Beginning { get; }

        /// <summary>Reason why the URDF is not valid; null if it is valid.</summary>
        public string Fault { get; }

        /// <summary>Returns whether an asset contains the text that this object summarises.</summary>
        public bool IsOf(RobotDescriptionAsset asset) => (asset.Urdf ?? "") == _urdf;

        static string BeginningOf(string urdf)
        {
            var shown = new StringBuilder();
            var start = 0;
            for (var line = 0; line < Lines && start < urdf.Length; line++)
            {
                var end = urdf.IndexOf('\n', start);
                if (end < 0) end = urdf.Length;
                var length = Math.Min(end - start, LineLength);
                shown.Append(urdf, start, length).Append(length < end - start ? "…\n" : "\n");
                start = end + 1;
            }
            return shown.Append(start < urdf.Length ? "…" : "").ToString().TrimEnd();
        }
    }
}
