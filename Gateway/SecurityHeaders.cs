namespace Nowpose.Gateway;

/// <summary>Adds headers to every answer that disable content sniffing and framing by other sites.</summary>
static class SecurityHeaders
{
    /// <summary>Policy of an answer that is not a page: it must not run or load anything.</summary>
    const string NoPage = "default-src 'none'; frame-ancestors 'none'";

    public static Task AddAsync(HttpContext context, RequestDelegate next)
    {
        var headers = context.Response.Headers;
        headers.XContentTypeOptions = "nosniff";
        headers["Referrer-Policy"] = "no-referrer";
        headers.XFrameOptions = "DENY";
        headers.ContentSecurityPolicy = NoPage;
        return next(context);
    }
}
