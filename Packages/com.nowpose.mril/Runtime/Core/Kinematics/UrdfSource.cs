using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Xml;
using System.Xml.Linq;
using Nowpose.Messages;

namespace Nowpose.Kinematics
{
    /// <summary>Reads attributes of one URDF, and creates error messages with the name of the source and the line.</summary>
    sealed class UrdfSource
    {
        const int MaxDepth = 100;
        const int MaxQuoteLength = 60;
        readonly string _name;

        public UrdfSource(string name) => _name = name;

        public XElement ParseRoot(string text)
        {
            // A string that does not come from a file may still contain a byte order mark.
            text = text.TrimStart('\uFEFF');
            try
            {
                using (var reader = Reader(text)) RequireShallow(reader);
                using (var reader = Reader(text)) return XDocument.Load(reader, LoadOptions.SetLineInfo).Root;
            }
            catch (XmlException e)
            {
                throw Malformed(text, e);
            }
        }

        /// <summary>Returns a child element in the parent's own namespace, because extensions such as Gazebo's may reuse the element names.</summary>
        public static XElement Child(XElement parent, string name) => parent.Element(parent.Name.Namespace + name);

        public InputException Error(XElement at, string message)
        {
            var owner = at.AncestorsAndSelf().First(e => e.Parent?.Parent == null);
            var subject = owner.Name.LocalName + (Named(owner, out var name) ? " " + Quote(name) : "");
            if (at != owner) subject += " <" + at.Name.LocalName + ">";
            return new InputException(_name + ":" + ((IXmlLineInfo)at).LineNumber + ": " + subject + ": " + message);
        }

        public string RequiredName(XElement element, string attribute)
        {
            var name = (string)element.Attribute(attribute);
            if (string.IsNullOrWhiteSpace(name)) throw Error(element, UrdfMessages.AttributeMissing(attribute));
            return name;
        }

        public double Number(XElement element, string attribute, double absent)
        {
            var text = (string)element?.Attribute(attribute);
            return text == null ? absent : Parse(element, attribute, text);
        }

        public (double X, double Y, double Z) Triple(XElement element, string attribute, (double, double, double) absent)
        {
            if (element?.Attribute(attribute) == null) return absent;
            var numbers = Numbers(element, attribute);
            if (numbers.Length != 3) throw Error(element, UrdfMessages.NotATriple(attribute, numbers.Length));
            return (numbers[0], numbers[1], numbers[2]);
        }

        public double[] Numbers(XElement element, string attribute) => ((string)element.Attribute(attribute) ?? "")
            .Split((char[])null, StringSplitOptions.RemoveEmptyEntries)
            .Select(part => Parse(element, attribute, part))
            .ToArray();

        public RigidTransform Origin(XElement parent)
        {
            var origin = Child(parent, "origin");
            var (x, y, z) = Triple(origin, "xyz", (0, 0, 0));
            var (roll, pitch, yaw) = Triple(origin, "rpy", (0, 0, 0));
            return RigidTransform.FromXyzRpy(x, y, z, roll, pitch, yaw);
        }

        public static string Quote(string text) =>
            "'" + (text.Length <= MaxQuoteLength ? text : text.Substring(0, MaxQuoteLength) + "…") + "'";

        double Parse(XElement element, string attribute, string text)
        {
            const NumberStyles plain = NumberStyles.Float;
            if (!double.TryParse(text, plain, CultureInfo.InvariantCulture, out var number) || !double.IsFinite(number))
                throw Error(element, UrdfMessages.NotANumber(attribute, Quote(text), text.Contains("${")));
            return number;
        }

        static bool Named(XElement element, out string name) => (name = (string)element.Attribute("name")) != null;

        static XmlReader Reader(string text) => XmlReader.Create(
            new StringReader(text), new XmlReaderSettings { DtdProcessing = DtdProcessing.Prohibit, XmlResolver = null });

        // XDocument walks up to the root for each node that is added, so a nesting of 100 000 levels would take minutes.
        void RequireShallow(XmlReader reader)
        {
            while (reader.Read())
            {
                if (reader.Depth > MaxDepth)
                    throw new InputException(UrdfMessages.TooDeep(_name, ((IXmlLineInfo)reader).LineNumber, MaxDepth));
            }
        }

        InputException Malformed(string text, XmlException e)
        {
            var isDtd = e.Message.Contains("DTD", StringComparison.OrdinalIgnoreCase);
            // For a document type declaration, the reader reports an earlier line.
            var line = isDtd ? 1 + text.Take(text.IndexOf("<!DOCTYPE", StringComparison.Ordinal)).Count(c => c == '\n') : e.LineNumber;
            var reason = isDtd ? UrdfMessages.DocumentType : UrdfMessages.NotWellFormed(e.Message);
            return new InputException(_name + ":" + Math.Max(1, line) + ": " + reason, e);
        }

    }
}
