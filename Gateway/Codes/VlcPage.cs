using System.Globalization;
using System.Text;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Codes;

/// <summary>
/// Serves a page that shows the control time as a code for cameras, for calibration with a monitor instead of LEDs. Handles the page's
/// requests for the time.
/// </summary>
/// <remarks>
/// The page contains no data and needs no token, because a browser that opens an address cannot send a token. A request for the time needs
/// a token if the gateway has tokens. The page requests the time by POST, because browsers always send the Origin header with it.
/// </remarks>
/// <param name="html">The page; null if it was not built.</param>
sealed class VlcPage(GatewayOptions options, IControlClock clock, AccessControl accessControl, ConnectionCounters counters, string html)
{
    public const string Path = "/vlc";
    const string TimePath = "/vlc/time";

    readonly HtmlPage _page = new(html);
    readonly TimeRequestLimits _places = new(options, accessControl, counters);

    public bool IsBuilt => _page.IsBuilt;

    /// <summary>Handles requests for the page and for the time. Passes on all others.</summary>
    public Task ServeAsync(HttpContext context, RequestDelegate next)
    {
        // Reads the time first, because any work before it would count as network latency.
        var received = clock.Now;
        if (context.Request.Path == TimePath) return SendTimeAsync(context, received);
        return context.Request.Path == Path ? ShowAsync(context) : next(context);
    }

    async Task ShowAsync(HttpContext context)
    {
        if (!await accessControl.AdmitOriginAsync(context)) return;
        if (!HttpMethods.IsGet(context.Request.Method)) await AccessControl.RefuseMethodAsync(context, "GET");
        else await SendPageAsync(context);
    }

    Task SendPageAsync(HttpContext context)
    {
        // With cross-origin isolation, browsers give the page a clock of finer resolution.
        context.Response.Headers["Cross-Origin-Opener-Policy"] = "same-origin";
        context.Response.Headers["Cross-Origin-Embedder-Policy"] = "require-corp";
        return _page.SendAsync(context);
    }

    async Task SendTimeAsync(HttpContext context, ControlTime received)
    {
        if (await accessControl.AdmitAsync(context) is not { } role) return;
        if (!HttpMethods.IsPost(context.Request.Method))
        {
            await AccessControl.RefuseMethodAsync(context, "POST");
            return;
        }
        if (!await _places.AdmitAsync(context, role)) return;
        context.Response.ContentType = "application/json";
        context.Response.Headers.CacheControl = "no-store";
        var answer = TimeText(received);
        context.Response.ContentLength = answer.Length;
        await context.Response.Body.WriteAsync(answer);
    }

    // Writes times as strings, because a number in JavaScript cannot hold nanoseconds since 1970 exactly.
    byte[] TimeText(ControlTime received)
    {
        var stepNs = clock.Resolution.Ticks * TimeSpan.NanosecondsPerTick;
        var isSynchronised = clock.IsSynchronised ? "true" : "false";
        FormattableString text = $$"""
            {"t2_ns":"{{received.Nanoseconds}}","resolution_ns":{{stepNs}},"is_synchronised":{{isSynchronised}},"t3_ns":"{{clock.Now.Nanoseconds}}"}
            """;
        return Encoding.UTF8.GetBytes(text.ToString(CultureInfo.InvariantCulture));
    }
}
