using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>Whether the displayed robot is the one that the gateway describes.</summary>
    enum RobotDescriptionMatch
    {
        /// <summary>The gateway has not sent a valid description.</summary>
        Unknown,

        Same,

        /// <summary>The texts differ: other lengths, axes or names may cause a wrong pose of the displayed robot.</summary>
        Different,
    }

    /// <summary>The newest valid robot description from the gateway, compared with the displayed robot. Thread-safe.</summary>
    sealed class ReceivedDescription
    {
        readonly RobotModel _displayed;
        // One object holds the text and the model, so that readers never see the text of one description with the model of another.
        volatile Parsed _newest = new Parsed(null, null, default);
        volatile string _fault;

        public ReceivedDescription(RobotModel displayed) => _displayed = displayed;

        /// <summary>URDF text; null before one is received.</summary>
        public string Text => _newest.Text;

        public RobotModel Model => _newest.Model;

        public RobotDescriptionMatch Match => _newest.Match;

        /// <summary>Error of the newest text, in one line; null if the text is valid.</summary>
        public string Fault => _fault;

        /// <summary>Reads a description, unless it is the current one: the gateway sends it again after each reconnection.</summary>
        /// <returns>False if the description cannot be read; the previous one is kept.</returns>
        public bool Receive(string urdf)
        {
            string fault = null;
            try
            {
                if (urdf != Text) _newest = Read(urdf);
            }
            catch (InputException notUrdf)
            {
                fault = notUrdf.Message;
            }
            _fault = fault;
            return fault == null;
        }

        Parsed Read(string urdf)
        {
            var model = UrdfReader.Read(urdf, RosTopics.RobotDescription);
            var isSame = model.SourceHash == _displayed.SourceHash;
            return new Parsed(urdf, model, isSame ? RobotDescriptionMatch.Same : RobotDescriptionMatch.Different);
        }

        sealed class Parsed
        {
            public Parsed(string text, RobotModel model, RobotDescriptionMatch match)
            {
                Text = text;
                Model = model;
                Match = match;
            }

            public string Text { get; }
            public RobotModel Model { get; }
            public RobotDescriptionMatch Match { get; }
        }
    }
}
