using System.Text;
using Nowpose.Unity.Messages;

namespace Nowpose.ArFoundation
{
    /// <summary>Checks the names of saved anchors. An anchor has the name of its cell.</summary>
    static class AnchorNames
    {
        /// <summary>
        /// Maximum length in bytes (UTF-8). OpenXR allows 255 (XR_MAX_SPATIAL_ANCHOR_NAME_SIZE_MSFT), and a store may append some characters.
        /// </summary>
        public const int MaxBytes = 240;

        /// <summary>Returns the reason why a name is invalid; null if the name is valid.</summary>
        public static string FaultOf(string name)
        {
            if (string.IsNullOrWhiteSpace(name)) return DeviceMessages.AnchorWithoutName;
            var length = Encoding.UTF8.GetByteCount(name);
            return length <= MaxBytes ? null : DeviceMessages.AnchorNameTooLong(length, MaxBytes);
        }
    }
}
