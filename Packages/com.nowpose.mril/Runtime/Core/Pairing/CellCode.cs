using System;
using System.Globalization;
using System.Net;
using System.Text;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;

namespace Nowpose.Pairing
{
    /// <summary>
    /// Content of the code on the robot's marker: the cell's name, the gateway's address, and the marker's pose in the base frame. Not secret.
    /// </summary>
    /// <remarks>Immutable. Each marker of a cell has its own code, because their offsets differ.</remarks>
    sealed class CellCode
    {
        public const int Version = 1;
        public const double MinSizeMetres = 0.01, MaxSizeMetres = 5;

        internal const string Kind = "cell";
        const string Keys = "nhswpom";
        const int PinBytes = 32;

        /// <param name="cell">Name of the cell, 1 to 40 letters, digits, spaces, hyphens, underscores and full stops.</param>
        /// <param name="host">Name or address of the gateway, in ASCII.</param>
        /// <param name="pin">The gateway's public key; null only for a gateway on the headset's own machine, which needs no TLS.</param>
        /// <param name="marker">Pose of the marker in the base frame; null if the code does not specify it.</param>
        /// <param name="sizeMetres">Edge length of the printed code in metres; 0 if it is unknown.</param>
        /// <exception cref="InputException">A value is invalid, or the values together do not fit into a code.</exception>
        public CellCode(
            string cell, string host, CertificatePin pin, MarkerOffset marker = null, double sizeMetres = 0,
            int syncPort = ProtocolLimits.SyncPort, int webSocketPort = ProtocolLimits.WebSocketPort)
            : this(cell, host, pin, marker, sizeMetres, syncPort, webSocketPort, null) { }

        CellCode(string cell, string host, CertificatePin pin, MarkerOffset marker, double sizeMetres, int syncPort, int webSocketPort, string text)
        {
            Cell = CellName.Require(cell, "cell code: name");
            Host = GatewayHost.Require(host, "cell code: host");
            if (pin == null && !ConnectionSettings.IsLoopbackHost(Host))
                throw new InputException(PairingCodeMessages.PinMissing);
            Pin = pin;
            Marker = marker;
            if (sizeMetres != 0) SettingRange.Require(sizeMetres, MinSizeMetres, MaxSizeMetres, SettingNames.CodeMarkerSize, "m");
            SizeMetres = sizeMetres;
            SyncPort = SettingRange.RequireCount(syncPort, 1, IPEndPoint.MaxPort, SettingNames.CodeSyncPort);
            WebSocketPort = SettingRange.RequireCount(webSocketPort, 1, IPEndPoint.MaxPort, SettingNames.CodeWebSocketPort);
            Text = text ?? Write();
        }

        public string Cell { get; }

        /// <summary>Name or address of the gateway, in lower case.</summary>
        public string Host { get; }

        public int SyncPort { get; }
        public int WebSocketPort { get; }

        /// <summary>The gateway's public key; null only for a host on the headset's own machine.</summary>
        public CertificatePin Pin { get; }

        /// <summary>The marker's pose in the base frame; null if the code does not specify it.</summary>
        public MarkerOffset Marker { get; }

        /// <summary>Edge length of the printed code in metres; 0 if it is unknown.</summary>
        public double SizeMetres { get; }

        /// <summary>The exact text of the printed code.</summary>
        public string Text { get; }

        /// <param name="text">String of any length; a string longer than <see cref="PairingCode.MaxLength"/> is rejected.</param>
        /// <exception cref="InputException">The text is not a cell code of this version, or a value is invalid; the message is one line.</exception>
        public static CellCode Parse(string text)
        {
            var fields = new CodeFields(text, Kind, Version, Keys);
            var offset = fields.OptionalText('o');
            return new CellCode(
                CellName.Decode(fields.Text('n'), "cell code: name"), fields.Text('h'), PinOf(fields),
                offset == null ? null : MarkerOffset.Parse(offset, SettingNames.CodeMarkerOffset), SizeOf(fields),
                (int)fields.Count('s', ProtocolLimits.SyncPort, 1, IPEndPoint.MaxPort),
                (int)fields.Count('w', ProtocolLimits.WebSocketPort, 1, IPEndPoint.MaxPort), text);
        }

        /// <summary>Returns whether both codes have the same host, ports and key.</summary>
        public bool HasSameGateway(CellCode other) =>
            other.Host == Host && Equals(other.Pin, Pin) && other.SyncPort == SyncPort && other.WebSocketPort == WebSocketPort;

        /// <param name="token">The headset's token for the gateway; null if it has none.</param>
        /// <param name="publishesDisplayed">Whether the displayed joints are published to the gateway.</param>
        public ConnectionSettings ToConnection(string token, string headsetName, bool publishesDisplayed = true) =>
            new ConnectionSettings(Host, SyncPort, WebSocketPort, Pin, token: token, headsetName: headsetName, publishesDisplayed: publishesDisplayed);

        /// <inheritdoc cref="Text"/>
        public override string ToString() => Text;

        internal static CertificatePin PinOf(CodeFields fields)
        {
            var text = fields.OptionalText('p');
            if (text == null) return null;
            if (!Base64Url.TryRead(text, PinBytes, out var hash)) throw fields.Fault(PairingCodeMessages.PinInvalid);
            return CertificatePin.Parse(System.Convert.ToBase64String(hash));
        }

        internal static string TextOf(CertificatePin pin) =>
            Base64Url.Write(System.Convert.FromBase64String(pin.ToString().Substring("sha256/".Length)));

        static double SizeOf(CodeFields fields)
        {
            var text = fields.OptionalText('m');
            if (text == null) return 0;
            // Callers use zero for an unknown size; a code omits the field instead.
            return MarkerOffset.TryReadNumber(text, out var size) && size != 0 ? size : throw fields.Fault(PairingCodeMessages.MarkerSize(MarkerOffset.Write(MinSizeMetres), MarkerOffset.Write(MaxSizeMetres)));
        }

        string Write()
        {
            var text = new StringBuilder(PairingCode.Scheme).Append(Kind).Append('/').Append(Version).Append("?n=").Append(Uri.EscapeDataString(Cell));
            text.Append("&h=").Append(Host);
            if (SyncPort != ProtocolLimits.SyncPort) text.Append("&s=").Append(SyncPort.ToString(CultureInfo.InvariantCulture));
            if (WebSocketPort != ProtocolLimits.WebSocketPort) text.Append("&w=").Append(WebSocketPort.ToString(CultureInfo.InvariantCulture));
            if (Pin != null) text.Append("&p=").Append(TextOf(Pin));
            if (Marker != null) text.Append("&o=").Append(Marker);
            if (SizeMetres != 0) text.Append("&m=").Append(MarkerOffset.Write(SizeMetres));
            return text.Length <= PairingCode.MaxLength ? text.ToString() : throw new InputException(
                PairingCodeMessages.CellCodeTooLong(text.Length, PairingCode.MaxLength));
        }
    }
}
