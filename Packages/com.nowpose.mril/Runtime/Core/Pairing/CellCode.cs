using System.Globalization;
using System.Net;
using System.Text;
using Nowpose.Network;
using Nowpose.Protocol;

namespace Nowpose.Pairing
{
    /// <summary>
    /// What the robot's marker says: which cell this is, how to reach its gateway, and where the marker is in the base frame. No secret.
    /// </summary>
    /// <remarks>Immutable. Each marker of a cell has a code of its own: they differ in the offset.</remarks>
    sealed class CellCode
    {
        public const int Version = 1;
        public const double LeastSizeMetres = 0.01, GreatestSizeMetres = 5;

        internal const string Kind = "cell";
        const string Keys = "nhswpom";
        const int PinBytes = 32;

        /// <param name="cell">Name of the cell, 1 to 40 letters, digits, blanks, hyphens, underscores and full stops.</param>
        /// <param name="host">Of the gateway: a name or an address in ASCII.</param>
        /// <param name="pin">The gateway's public key; null for a gateway on the headset's own machine only, which is reached without TLS.</param>
        /// <param name="marker">Null for a code that tells nothing of where the base frame is.</param>
        /// <param name="sizeMetres">Edge of the printed code; 0 where it is not known.</param>
        /// <exception cref="InputException">A value cannot be used, or all together do not fit into a code.</exception>
        public CellCode(
            string cell, string host, CertificatePin pin, MarkerOffset marker = null, double sizeMetres = 0,
            int syncPort = ProtocolLimits.SyncPort, int webSocketPort = ProtocolLimits.WebSocketPort)
            : this(cell, host, pin, marker, sizeMetres, syncPort, webSocketPort, null) { }

        CellCode(string cell, string host, CertificatePin pin, MarkerOffset marker, double sizeMetres, int syncPort, int webSocketPort, string text)
        {
            Cell = CellName.Require(cell, "cell code: name");
            Host = GatewayHost.Require(host, "cell code: host");
            if (pin == null && !GatewayHost.IsLoopback(Host))
                throw new InputException(
                    "cell code: certificate pin is missing, without which only a gateway on the headset's own machine can be used");
            Pin = pin;
            Marker = marker;
            if (sizeMetres != 0) SettingRange.Require(sizeMetres, LeastSizeMetres, GreatestSizeMetres, "cell code: marker size", "m");
            SizeMetres = sizeMetres;
            SyncPort = SettingRange.RequireCount(syncPort, 1, IPEndPoint.MaxPort, "cell code: sync port");
            WebSocketPort = SettingRange.RequireCount(webSocketPort, 1, IPEndPoint.MaxPort, "cell code: WebSocket port");
            Text = text ?? Write();
        }

        public string Cell { get; }

        /// <summary>In lower case.</summary>
        public string Host { get; }

        public int SyncPort { get; }
        public int WebSocketPort { get; }

        /// <summary>Null only for a host on the headset's own machine.</summary>
        public CertificatePin Pin { get; }

        /// <summary>Null where the code does not say.</summary>
        public MarkerOffset Marker { get; }

        /// <summary>Edge of the printed code; 0 where it is not known.</summary>
        public double SizeMetres { get; }

        /// <summary>What is in the printed code, to the letter.</summary>
        public string Text { get; }

        /// <param name="text">Of any length; no longer than <see cref="PairingCode.GreatestLength"/> is read.</param>
        /// <exception cref="InputException">It is no cell code of this version, or a value cannot be used; one line.</exception>
        public static CellCode Parse(string text)
        {
            var fields = new CodeFields(text, Kind, Version, Keys);
            var offset = fields.OptionalText('o');
            return new CellCode(
                CellName.Decode(fields.Text('n'), "cell code: name"), fields.Text('h'), PinOf(fields),
                offset == null ? null : MarkerOffset.Parse(offset, "cell code: marker offset"), SizeOf(fields),
                (int)fields.Count('s', ProtocolLimits.SyncPort, 1, IPEndPoint.MaxPort),
                (int)fields.Count('w', ProtocolLimits.WebSocketPort, 1, IPEndPoint.MaxPort), text);
        }

        /// <summary>Whether both lead to the same ports of the same host and trust the same key.</summary>
        public bool HasSameGateway(CellCode other) =>
            other.Host == Host && Equals(other.Pin, Pin) && other.SyncPort == SyncPort && other.WebSocketPort == WebSocketPort;

        /// <param name="token">What the gateway gave this headset; null for none.</param>
        public ConnectionSettings ToConnection(string token, string headsetName) =>
            new ConnectionSettings(Host, SyncPort, WebSocketPort, Pin, token: token, headsetName: headsetName);

        /// <inheritdoc cref="Text"/>
        public override string ToString() => Text;

        internal static CertificatePin PinOf(CodeFields fields)
        {
            var text = fields.OptionalText('p');
            if (text == null) return null;
            if (!Base64Url.TryRead(text, PinBytes, out var hash)) throw fields.Fault("certificate pin is not the base64url of 32 bytes");
            return CertificatePin.Parse(System.Convert.ToBase64String(hash));
        }

        internal static string TextOf(CertificatePin pin) =>
            Base64Url.Write(System.Convert.FromBase64String(pin.ToString().Substring("sha256/".Length)));

        static double SizeOf(CodeFields fields)
        {
            var text = fields.OptionalText('m');
            if (text == null) return 0;
            // Zero is how a caller says "not known"; a code leaves it out.
            return MarkerOffset.TryReadNumber(text, out var size) && size != 0 ? size : throw fields.Fault("marker size is no number; allowed are "
                + MarkerOffset.Write(LeastSizeMetres) + " to " + MarkerOffset.Write(GreatestSizeMetres) + " m");
        }

        string Write()
        {
            var text = new StringBuilder(PairingCode.Scheme).Append(Kind).Append('/').Append(Version).Append("?n=").Append(CellName.Encode(Cell));
            text.Append("&h=").Append(Host);
            if (SyncPort != ProtocolLimits.SyncPort) text.Append("&s=").Append(SyncPort.ToString(CultureInfo.InvariantCulture));
            if (WebSocketPort != ProtocolLimits.WebSocketPort) text.Append("&w=").Append(WebSocketPort.ToString(CultureInfo.InvariantCulture));
            if (Pin != null) text.Append("&p=").Append(TextOf(Pin));
            if (Marker != null) text.Append("&o=").Append(Marker);
            if (SizeMetres != 0) text.Append("&m=").Append(MarkerOffset.Write(SizeMetres));
            return text.Length <= PairingCode.GreatestLength ? text.ToString() : throw new InputException(
                "cell code: " + text.Length + " characters; allowed are up to " + PairingCode.GreatestLength
                + "; shorten the names of cell and host");
        }
    }
}
