using System.Globalization;
using Nowpose.Pairing;
using Nowpose.Protocol;

namespace Nowpose.Messages
{
    /// <summary>Questions and messages to the wearer about pairing.</summary>
    static class PairingMessages
    {
        public const string LookAtMarker = "look at the robot's marker";
        public const string CodeWasTried = "this code has already been tried; request another one on the gateway's page or terminal";
        public const string MarkerFirst = "the gateway's code has been read; now look at the robot's marker";

        /// <param name="known">Accepted code of the cell with the same name; null if there is none.</param>
        public static string Question(CellCode code, CellCode known)
        {
            if (known == null)
                return "Connect to cell '" + code.Cell + "'? Gateway " + code.Host + ", ports " + Ports(code) + ", " + Key(code.Pin);
            return "Cell '" + code.Cell + "' has a different gateway than before. Connect? Gateway " + Changed(code.Host, known.Host)
                + ", ports " + Changed(Ports(code), Ports(known)) + ", " + Changed(Key(code.Pin), Key(known.Pin));
        }

        public static string Use(string cell, string instead) => "Use cell '" + cell + "' instead of '" + instead + "'?";

        public static string TooMany(string cell) =>
            "cell '" + cell + "': the maximum of " + PairedCell.MaxCodes
            + " markers is reached; forget the cell to read other markers";

        public static string Forget(CellCode code) =>
            "Forget cell '" + code.Cell + "'? To use it again, look at its marker" + (code.Pin == null ? "" : " and at its gateway's code");

        public static string LookAtCode(string cell) => "cell '" + cell + "': look at the code that its gateway shows";

        public static string TokenRefused(string cell) =>
            "cell '" + cell + "': its gateway no longer accepts this headset; look at the code that the gateway shows";

        public static string Exchanging(string cell) => "cell '" + cell + "': pairing";
        public static string Paired(string cell) => "cell '" + cell + "': paired";
        public static string Known(string cell) => "cell '" + cell + "': already paired";

        /// <summary>Returns the status for the case that there is neither a question nor a problem.</summary>
        /// <param name="exchanging">The cell whose token is being exchanged; null if there is none.</param>
        /// <param name="used">The cell in use; null if there is none.</param>
        public static string Calm(string exchanging, PairedCell used, bool isTokenRefused)
        {
            if (exchanging != null) return Exchanging(exchanging);
            if (used == null) return LookAtMarker;
            if (isTokenRefused) return TokenRefused(used.Cell);
            return used.IsReady ? Known(used.Cell) : LookAtCode(used.Cell);
        }

        static string Changed(string now, string before) => now == before ? now : now + " instead of " + before;
        static string Ports(CellCode code) => Number(code.SyncPort) + " and " + Number(code.WebSocketPort);

        static string Key(CertificatePin pin) => pin == null ? "no encryption" : "key " + pin.Beginning;

        static string Number(int port) => port.ToString(CultureInfo.InvariantCulture);
    }
}
