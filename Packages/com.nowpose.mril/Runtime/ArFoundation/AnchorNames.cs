using Nowpose.Unity.Messages;

namespace Nowpose.ArFoundation
{
    /// <summary>Checks the names of saved anchors. An anchor has the name of its cell.</summary>
    static class AnchorNames
    {
        /// <summary>Maximum length in characters: enough for the name of a cell. The limits of the stores are not documented.</summary>
        public const int MaxLength = 128;

        /// <summary>Returns the reason why a name is invalid; null if the name is valid.</summary>
        public static string FaultOf(string name)
        {
            if (string.IsNullOrWhiteSpace(name)) return DeviceMessages.AnchorWithoutName;
            return name.Length <= MaxLength
                ? null
                : DeviceMessages.AnchorNameTooLong(name.Length, MaxLength);
        }
    }
}
