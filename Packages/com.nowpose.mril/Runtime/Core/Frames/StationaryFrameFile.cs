using System;
using System.Globalization;
using System.IO;
using System.Text;
using Newtonsoft.Json;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Frames
{
    /// <summary>Reads and writes the poses of stationary frames in a file. The file contains the tf2_msgs/TFMessage of /tf_static as JSON.</summary>
    static class StationaryFrameFile
    {
        const int MaxBytes = 1024 * 1024, Nesting = 6;

        /// <exception cref="InputException">The file cannot be read or is invalid; the message names the file, the line, the frame and the reason.</exception>
        public static TransformsMessage Load(string path)
        {
            var text = WholeFile.Read(path, MaxBytes);
            var utf8 = Encoding.UTF8.GetBytes(text);
            var json = new JsonUtf8Reader(utf8, Nesting);
            var message = new TransformsReader().Read(ref json, isStatic: true);
            if (message != null && json.End()) return message;
            var fault = string.IsNullOrWhiteSpace(text) ? FrameMessages.FileEmpty
                : InvalidTransform.Describe(text, json.Fault) ?? WordsOf(json.Fault);
            throw new InputException(FrameMessages.FileLine(path, LineAt(utf8, json.Position), fault));
        }

        /// <exception cref="InputException">The file cannot be written; the old file is unchanged.</exception>
        public static void Save(string path, TransformsMessage message)
        {
            var text = new StringWriter(CultureInfo.InvariantCulture) { NewLine = "\n" };
            using var json = new JsonTextWriter(text) { Formatting = Formatting.Indented };
            message.Write(json, RosTimeForm.Sec);
            json.Flush();
            WholeFile.Write(path, text + "\n", FrameMessages.List);
        }

        static int LineAt(byte[] utf8, int position)
        {
            var line = 1;
            for (var i = 0; i < Math.Min(position, utf8.Length); i++)
                if (utf8[i] == '\n') line++;
            return line;
        }

        static string WordsOf(DropReason fault)
        {
            switch (fault)
            {
                case DropReason.NotUnitQuaternion: return FrameMessages.NotUnitQuaternion(FrameTransform.NormTolerance.ToString(CultureInfo.InvariantCulture));
                case DropReason.NotFinite: return FrameMessages.FileNumber;
                case DropReason.OwnParent: return FrameMessages.OwnParent;
                case DropReason.DuplicateName: return FrameMessages.ChildTwice;
                case DropReason.TooManyFrames: return FrameMessages.TooManyFrames(ProtocolLimits.Frames);
                case DropReason.MissingField: return FrameMessages.NoTransforms;
                default: return FrameMessages.NotTransforms(fault);
            }
        }
    }
}
