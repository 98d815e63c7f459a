using System.Globalization;
using Nowpose.Protocol;

namespace Nowpose.Pairing
{
    /// <summary>What the wearer is asked and told.</summary>
    static class PairingWords
    {
        /// <summary>So many characters of a pin a person compares with what the gateway prints.</summary>
        const int PinCharacters = 12;

        public const string LookAtMarker = "look at the robot's marker";
        public const string MarkerFirst = "the gateway's code is read; now look at the robot's marker";

        /// <param name="known">What was agreed to under that name before; null for nothing.</param>
        public static string Question(CellCode code, CellCode known)
        {
            if (known == null)
                return "Connect to cell '" + code.Cell + "'? Gateway " + code.Host + ", ports " + Number(code.SyncPort) + " and "
                    + Number(code.WebSocketPort) + ", " + Key(code.Pin);
            var host = code.Host == known.Host ? code.Host : code.Host + " instead of " + known.Host;
            var key = Equals(code.Pin, known.Pin) ? Key(code.Pin) : Key(code.Pin) + " instead of " + Key(known.Pin);
            return "Cell '" + code.Cell + "' has another gateway than before. Connect? Gateway " + host + ", ports " + Number(code.SyncPort) + " and "
                + Number(code.WebSocketPort) + ", " + key;
        }

        public static string Forget(CellCode code) =>
            "Forget cell '" + code.Cell + "'? To use it again, look at its marker" + (code.Pin == null ? "" : " and at its gateway's code");

        public static string LookAtCode(string cell) => "cell '" + cell + "': look at the code that its gateway shows";

        public static string TokenRefused(string cell) =>
            "cell '" + cell + "': its gateway does not accept this headset any more; look at the code that it shows";

        public static string Exchanging(string cell) => "cell '" + cell + "': pairing";
        public static string Paired(string cell) => "cell '" + cell + "': paired";
        public static string Known(string cell) => "cell '" + cell + "': known";

        static string Key(CertificatePin pin) =>
            pin == null ? "no encryption" : "key " + pin.ToString().Substring("sha256/".Length, PinCharacters) + "…";

        static string Number(int port) => port.ToString(CultureInfo.InvariantCulture);
    }
}
