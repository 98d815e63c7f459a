using Nowpose.Unity.Messages;

namespace Nowpose.ArFoundation
{
    /// <summary>Checks names of saved anchors. The name of a cell is used unchanged.</summary>
    static class AnchorNames
    {
        /// <summary>Maximum length in characters: enough for the name of a cell. The stores' own limits are not known.</summary>
        public const int MaxLength = 128;

        /// <summary>Returns why a name cannot be used; null if it can.</summary>
        public static string FaultOf(string name)
        {
            if (string.IsNullOrWhiteSpace(name)) return DeviceMessages.AnchorWithoutName;
            return name.Length <= MaxLength
                ? null
                : DeviceMessages.AnchorNameTooLong(name.Length, MaxLength);
        }
    }
}
