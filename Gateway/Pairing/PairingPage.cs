using System.Net;
using System.Text;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.VisibleLight;
using Nowpose.Pairing;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Pairing;

/// <summary>The page that shows the code and prints markers, and what it asks for. For browsers on this machine only.</summary>
/// <remarks>
/// Who can open it can pair a headset, and a browser has no token to show when it opens a page. From elsewhere the page comes through
/// a tunnel of somebody who may log in here, or the verb "pair" shows the code on a terminal.
/// </remarks>
/// <param name="html">Null where it was not built.</param>
sealed class PairingPage(GatewayOptions options, ShownCode shown, ConnectionCounters counters, Action<string> log, string html)
{
    readonly byte[] _page = html == null ? null : Encoding.UTF8.GetBytes(html);
    readonly Door _door = new(options, counters, log);

    /// <summary>Of both servers, once they are known.</summary>
    public int SyncPort { get; set; }

    /// <inheritdoc cref="SyncPort"/>
    public int WebSocketPort { get; set; }

    public bool IsBuilt => _page != null;

    CertificatePin Pin => options.Certificate == null ? null : CertificatePin.Of(options.Certificate);

    /// <summary>GET /pair.</summary>
    public async Task ShowAsync(HttpContext context)
    {
        if (!await AdmitAsync(context)) return;
        if (!IsBuilt)
        {
            await Door.AnswerAsync(context, StatusCodes.Status503ServiceUnavailable, CodePage.MissingPage);
            return;
        }

        var response = context.Response;
        response.ContentType = "text/html; charset=utf-8";
        response.ContentLength = _page.Length;
        response.Headers.CacheControl = "no-store";
        response.Headers.Connection = "close";
        // Another site that frames it could have the visitor click "print" or read along.
        response.Headers.XFrameOptions = "DENY";
        await response.Body.WriteAsync(_page);
    }

    /// <summary>POST /pair/code: {"renew": ""} for another one.</summary>
    public async Task TellCodeAsync(HttpContext context)
    {
        if (!await AdmitAsync(context) || await SmallJson.ReadAsync(context) is not { } request) return;
        if (request.ContainsKey("renew")) shown.Discard();
        var code = shown.Current(out var left);
        await SmallJson.AnswerAsync(context, new { text = code.Text, left_s = left.TotalSeconds, key = code.Pin?.Beginning ?? "" });
    }

    /// <summary>POST /pair/cell: the marker's code of name, host, offset and size_mm; with nothing what to begin with.</summary>
    public async Task TellCellAsync(HttpContext context)
    {
        if (!await AdmitAsync(context) || await SmallJson.ReadAsync(context) is not { } request) return;
        if (!request.ContainsKey("name"))
            await SmallJson.AnswerAsync(context, new { name = options.Cell ?? "", hosts = Hosts(), has_pin = Pin != null });
        else
            await AnswerCellAsync(context, request);
    }

    Task AnswerCellAsync(HttpContext context, Dictionary<string, string> request)
    {
        string Field(string name) => request.GetValueOrDefault(name, "").Trim();
        try
        {
            var offset = Field("offset");
            if (!MarkerOffset.TryReadNumber(Field("size_mm"), out var sizeMm) || sizeMm <= 0)
                throw new InputException($"marker size: '{Field("size_mm")}' is no size; allowed are 10 to 999 mm");
            var code = new CellCode(
                Field("name"), Field("host"), Pin, offset.Length == 0 ? null : MarkerOffset.Parse(offset, "marker offset"), sizeMm / 1000,
                SyncPort, WebSocketPort);
            return SmallJson.AnswerAsync(context, new { text = code.Text });
        }
        catch (InputException fault)
        {
            return SmallJson.AnswerAsync(context, new { fault = fault.Message });
        }
    }

    // Behind a plain gateway there is nobody but this machine.
    string[] Hosts() => options.Certificate == null
        ? ["localhost"] : [.. OwnHosts.Reachable(options.Bind).Select(host => host.Trim('[', ']'))];

    async Task<bool> AdmitAsync(HttpContext context)
    {
        if (!await _door.AdmitOriginAsync(context)) return false;
        if (IsFromThisMachine(context.Connection) && IsOwnHost(context)) return true;
        await Door.AnswerAsync(
            context, StatusCodes.Status403Forbidden,
            "the page of pairing is for browsers on the gateway's own machine, by its address, its name or localhost");
        return false;
    }

    // Nobody else gets an answer to an address that is this machine's own.
    static bool IsFromThisMachine(ConnectionInfo connection) =>
        IPAddress.IsLoopback(connection.RemoteIpAddress) || connection.RemoteIpAddress.Equals(connection.LocalIpAddress);

    // A page whose name was made to point here (DNS rebinding) would read along: it comes with its own name.
    bool IsOwnHost(HttpContext context) =>
        Uri.TryCreate($"{(options.Certificate == null ? "http" : "https")}://{context.Request.Host.Value}", UriKind.Absolute, out var uri)
        && OwnHosts.Contain(uri, context.Connection.LocalIpAddress);
}
