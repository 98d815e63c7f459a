namespace Nowpose.Cli.Messages;

/// <summary>Error messages about picture and video files, with remedies.</summary>
static class PictureMessages
{
    public static string VideoNotAlone(string video) => $"{video}: a video must be the only file; evaluate it separately";
    public static string NotFound(string path) => $"{path}: file or folder not found; correct the path";

    public static string NoPictures(string folder, string formats) =>
        $"{folder}: contains no pictures; pass a folder with pictures in one of the formats {formats}";

    public static string NotAPicture(string path, string pictures, string videos) =>
        $"{path}: is neither a picture ({pictures}) nor a video ({videos}); pass a file in one of these formats, or convert it";

    public const string FfmpegNeeded =
        "ffmpeg and ffprobe are needed to read videos and were not found; install ffmpeg, or pass pictures instead";

    public static string NoFramesByFfmpeg(string path, string reason) => $"{path}: ffmpeg finds no frames in it: {reason}; film again";

    public static string FrameOrder(string path, int frame) =>
        $"{path}: frame {frame} is not later than the previous frame, so the times of this video cannot be used; convert the video with ffmpeg";

    public static string NoFrames(string path, string reason) => $"{path}: ffprobe finds no frames in it: {reason}; film again";
    public static string NoVideo(string path, string reason) => $"{path}: ffprobe finds no video in it: {reason}; pass a video or pictures";
}
